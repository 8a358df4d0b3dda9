// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/segmentation/cpc_segmentation.h>

#include "workbench/peers/module.hpp"
#include "workbench/peers/pcl_convexity.hpp"

namespace cleave::peers {
namespace {

class PclCpc : public Peer {
 public:
  explicit PclCpc(const CpcParameters& parameters) : parameters_(parameters) {}

  void prepare(const segmentation::CloudView& cloud) override { cloud_ = to_pcl(cloud); }

  void segment(std::span<std::uint16_t> labels) override {
    const PclSupervoxels supervoxels = cluster(cloud_, parameters_.lccp.supervoxels);
    pcl::CPCSegmentation<PclPoint> cpc;
    set_up(cpc, parameters_.lccp, supervoxels);
    constexpr bool local = true, directed = true, clean = false;
    cpc.setCutting(parameters_.max_cuts, parameters_.cutting_min_segments,
                   parameters_.min_cut_score, local, directed, clean);
    cpc.setRANSACIterations(parameters_.ransac_iterations);
    cpc.segment();
    take_labels(cpc, supervoxels, labels);
  }

 private:
  CpcParameters parameters_;
  PclCloud::Ptr cloud_;
};

}  // namespace

}  // namespace cleave::peers

cleave::peers::Peer* cleave_new_pcl_cpc(const cleave::peers::CpcParameters& parameters) {
  cleave::peers::silence_pcl();
  return new cleave::peers::PclCpc(parameters);
}
