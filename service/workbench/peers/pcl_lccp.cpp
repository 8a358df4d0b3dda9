// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/peers/module.hpp"
#include "workbench/peers/pcl_convexity.hpp"

namespace cleave::peers {
namespace {

class PclLccp : public Peer {
 public:
  explicit PclLccp(const LccpParameters& parameters) : parameters_(parameters) {}

  void prepare(const segmentation::CloudView& cloud) override { cloud_ = to_pcl(cloud); }

  void segment(std::span<std::uint16_t> labels) override {
    const PclSupervoxels supervoxels = cluster(cloud_, parameters_.supervoxels);
    pcl::LCCPSegmentation<PclPoint> lccp;
    set_up(lccp, parameters_, supervoxels);
    lccp.segment();
    take_labels(lccp, supervoxels, labels);
  }

 private:
  LccpParameters parameters_;
  PclCloud::Ptr cloud_;
};

}  // namespace

}  // namespace cleave::peers

cleave::peers::Peer* cleave_new_pcl_lccp(const cleave::peers::LccpParameters& parameters) {
  cleave::peers::silence_pcl();
  return new cleave::peers::PclLccp(parameters);
}
