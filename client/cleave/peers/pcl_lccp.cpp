#include <pcl/segmentation/lccp_segmentation.h>

#include "cleave/peers/module.hpp"
#include "cleave/peers/pcl_supervoxels.hpp"

namespace cleave::peers {
namespace {

class PclLccp : public Peer {
 public:
  explicit PclLccp(const LccpParameters& parameters) : parameters_(parameters) {}

  void prepare(const segmentation::CloudView& cloud) override { cloud_ = to_pcl(cloud); }

  void segment(std::span<std::uint16_t> labels) override {
    const PclSupervoxels supervoxels = cluster(cloud_, parameters_.supervoxels);
    pcl::LCCPSegmentation<PclPoint> lccp;
    lccp.setConcavityToleranceThreshold(parameters_.concavity_tolerance_deg);
    lccp.setSanityCheck(parameters_.sanity_check);
    lccp.setSmoothnessCheck(false, 0, 0);
    lccp.setKFactor(parameters_.k_factor);
    lccp.setMinSegmentSize(parameters_.min_segment_supervoxels);
    lccp.setInputSupervoxels(supervoxels.clusters, supervoxels.adjacency);
    lccp.segment();
    std::map<std::uint32_t, std::uint32_t> segment_of;  // numbered from 1
    lccp.getSupervoxelToSegmentMap(segment_of);
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const auto found = segment_of.find((*supervoxels.labelled)[i].label);
      labels[i] = found == segment_of.end() ? 0 : static_cast<std::uint16_t>(found->second);
    }
  }

 private:
  LccpParameters parameters_;
  PclCloud::Ptr cloud_;
};

}  // namespace

}  // namespace cleave::peers

cleave::peers::Peer* cleave_new_pcl_lccp(const cleave::peers::LccpParameters& parameters) {
  return new cleave::peers::PclLccp(parameters);
}
