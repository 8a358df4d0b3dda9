// How long each stage of the segmentation takes.
#pragma once

#include <chrono>
#include <map>
#include <string>
#include <vector>

#include "cleave/console/json.hpp"
#include "segmentation/segmenter.hpp"

namespace cleave::client {

// Start it right before Segmenter::segment, which tells it when each stage ends.
class StageTimes : public segmentation::StageObserver {
 public:
  void start() { stage_began_ = std::chrono::steady_clock::now(); }
  void stage_ended(segmentation::Stage stage) override;
  // To be called when Segmenter::segment has returned.
  void end_cloud();

  [[nodiscard]] std::size_t clouds() const { return totals_ms_.size(); }
  // A line a stage and one for the total: median, 90 %, 99 %.
  [[nodiscard]] std::string table() const;
  // {"total_ms": {median, p90, p99}, "stages_ms": {"voxelise": {..}, ..}}
  [[nodiscard]] Json json() const;

 private:
  std::chrono::steady_clock::time_point stage_began_{};
  double cloud_ms_ = 0;
  std::map<segmentation::Stage, std::vector<double>> stages_ms_;
  std::vector<double> totals_ms_;
};

}  // namespace cleave::client
