// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>
#include <vector>

#include "segmentation/math/plane_fit.hpp"
#include "segmentation/partition/supervoxel_partition.hpp"
#include "workbench/peers/module.hpp"
#include "workbench/peers/pcl_supervoxels.hpp"

namespace cleave::peers {
namespace {

using segmentation::ForeignSupervoxels;

segmentation::Surfel fit(const pcl::Supervoxel<PclPoint>& supervoxel) {
  segmentation::Moments moments;
  for (const PclPoint& voxel : *supervoxel.voxels_) moments.add_point(voxel.x, voxel.y, voxel.z);
  // PCL's own mean normal is not a number for an isolated voxel.
  return {.position = supervoxel.centroid_.getVector3fMap(),
          .normal = segmentation::fit_normal(moments)};
}

class PclSsc : public Peer {
 public:
  PclSsc(const segmentation::Options& options, const SupervoxelParameters& supervoxels)
      : options_(options), parameters_(supervoxels) {}

  void prepare(const segmentation::CloudView& cloud) override { cloud_ = to_pcl(cloud); }

  void segment(std::span<std::uint16_t> labels) override {
    const PclSupervoxels supervoxels = cluster(cloud_, parameters_);
    take_over(supervoxels);
    partitioner_.partition(foreign_, options_, segment_);
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const std::uint32_t index = index_of((*supervoxels.labelled)[i].label);
      labels[i] = index == none ? 0 : static_cast<std::uint16_t>(segment_[index] + 1);
    }
  }

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFF;

  [[nodiscard]] std::uint32_t index_of(std::uint32_t label) const {
    return label < index_of_label_.size() ? index_of_label_[label] : none;
  }

  void take_over(const PclSupervoxels& supervoxels) {
    foreign_ = {};
    index_of_label_.clear();
    for (const auto& [label, supervoxel] : supervoxels.clusters) {
      index_of_label_.resize(label + 1, none);
      index_of_label_[label] = static_cast<std::uint32_t>(foreign_.surfel.size());
      foreign_.surfel.push_back(fit(*supervoxel));
    }
    foreign_.point_count.assign(foreign_.surfel.size(), 0);
    for (const auto& point : *supervoxels.labelled) {
      const std::uint32_t index = index_of(point.label);
      if (index != none) ++foreign_.point_count[index];
    }
    for (const auto& [label, neighbour] : supervoxels.adjacency) {
      const std::uint32_t first = index_of(label);
      const std::uint32_t second = index_of(neighbour);
      if (first != none && second != none && first < second) {
        foreign_.adjacent_pairs.push_back({first, second, 1});
      }
    }
    sort_pairs();
  }

  void sort_pairs() {
    const auto key = [](const segmentation::AdjacentPair& pair) {
      return std::pair(pair.first, pair.second);
    };
    auto& pairs = foreign_.adjacent_pairs;
    std::sort(pairs.begin(), pairs.end(),
              [&](const auto& a, const auto& b) { return key(a) < key(b); });
    pairs.erase(std::unique(pairs.begin(), pairs.end(),
                            [&](const auto& a, const auto& b) { return key(a) == key(b); }),
                pairs.end());
  }

  segmentation::Options options_;
  SupervoxelParameters parameters_;
  PclCloud::Ptr cloud_;
  segmentation::SupervoxelPartitioner partitioner_;
  ForeignSupervoxels foreign_;
  std::vector<std::uint32_t> index_of_label_;
  std::vector<std::uint32_t> segment_;
};

}  // namespace

}  // namespace cleave::peers

cleave::peers::Peer* cleave_new_pcl_ssc(const cleave::segmentation::Options& options,
                                        const cleave::peers::SupervoxelParameters& supervoxels) {
  cleave::peers::silence_pcl();
  return new cleave::peers::PclSsc(options, supervoxels);
}
