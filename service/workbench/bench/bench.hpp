// SPDX-License-Identifier: BSD-3-Clause
// Runs the segmentation, and what it is compared with, over one cloud after the other.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "segmentation/segmenter.hpp"
#include "workbench/bench/record.hpp"
#include "workbench/bench/stage_times.hpp"
#include "workbench/evaluation/labelled_cloud.hpp"
#include "workbench/peers/peer.hpp"

namespace cleave::workbench {

struct BenchPlan {
  segmentation::Options options{};
  std::uint32_t repeat = 1;        // timed runs a cloud and method
  std::uint32_t grid_offsets = 1;  // shifts of the grid, evenly over one voxel; 1 = as in `options`
  bool against_pcl = false;
  bool find_collapses = false;
};

// A run that went badly wrong although the plain method of the thesis shows that it need not.
struct Collapse {
  std::string cloud;
  float grid_offset = 0;
  double weighted_covering = 0;
  double of_thesis = 0;
};
inline constexpr double collapsed_below = 0.90;
inline constexpr double thesis_reaches = 0.97;

struct BenchResult {
  std::vector<double> points, segments;  // one a cloud
  Record ours;
  StageTimes times;
  std::vector<double> allocations;  // one a timed run; empty where they cannot be counted
  std::vector<std::pair<std::string, Record>> peers;
  std::vector<Collapse> collapses;
};

// One thread. Methods take turns on each cloud, so that whatever else the machine does meets all of
// them; what they need from the cloud is made before the clock runs.
class Bench {
 public:
  explicit Bench(const BenchPlan& plan);

  // The first run on a cloud is neither timed nor are its allocations counted. Throws
  // std::runtime_error where there is nothing to segment.
  void measure(const std::string& name, const evaluation::LabelledCloud& cloud);

  [[nodiscard]] const BenchResult& result() const { return result_; }

 private:
  struct Grid {
    float offset;
    segmentation::Segmenter segmenter;
  };

  void warm_up(const std::string& name, const evaluation::LabelledCloud& cloud);
  void run_peers(const evaluation::LabelledCloud& cloud, bool judged);
  void run_ours(Grid& grid, const evaluation::LabelledCloud& cloud);
  void judge_ours(const std::string& name, const Grid& grid,
                  const evaluation::LabelledCloud& cloud);
  [[nodiscard]] double covering_of_thesis(float grid_offset,
                                          const evaluation::LabelledCloud& cloud);

  BenchPlan plan_;
  std::vector<Grid> grids_;
  std::vector<std::unique_ptr<peers::Peer>> peers_;  // in the order of result_.peers
  StageClock clock_;
  std::vector<std::uint16_t> labels_;
  segmentation::Segmentation segmentation_;
  BenchResult result_;
};

}  // namespace cleave::workbench
