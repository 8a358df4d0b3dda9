// SPDX-License-Identifier: BSD-3-Clause
// How long each stage of the segmentation takes.
#pragma once

#include <array>
#include <vector>

#include "segmentation/segmenter.hpp"
#include "workbench/bench/thread_clock.hpp"

namespace cleave::workbench {

inline constexpr std::array all_stages = {
    segmentation::Stage::voxelise,     segmentation::Stage::normals,
    segmentation::Stage::supervoxels,  segmentation::Stage::graph,
    segmentation::Stage::partition,    segmentation::Stage::clean_up,
    segmentation::Stage::label_points, segmentation::Stage::describe};

// The stages of one run, in milliseconds of its thread. Allocates nothing, so that allocations can
// be counted while it looks on.
class StageClock : public segmentation::StageObserver {
 public:
  // Right before Segmenter::segment, which tells it when each stage ends.
  void start() {
    stages_ms_.fill(0);
    stage_began_ms_ = thread_ms();
  }
  void stage_ended(segmentation::Stage stage) override;

  [[nodiscard]] double stage_ms(segmentation::Stage stage) const {
    return stages_ms_[static_cast<std::size_t>(stage)];
  }
  [[nodiscard]] double total_ms() const;

 private:
  double stage_began_ms_ = 0;
  std::array<double, all_stages.size()> stages_ms_{};
};

// Of many runs: one value a run, in milliseconds.
struct StageTimes {
  std::array<std::vector<double>, all_stages.size()> stages;
  std::vector<double> total;

  void add(const StageClock& run);
  [[nodiscard]] const std::vector<double>& of(segmentation::Stage stage) const {
    return stages[static_cast<std::size_t>(stage)];
  }
};

}  // namespace cleave::workbench
