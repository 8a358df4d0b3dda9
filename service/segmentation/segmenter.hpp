// SPDX-License-Identifier: BSD-3-Clause
// Cloud in, labels and segments out: Spectral Supervoxel Clustering (S. Alexandrov, "Geometrical
// Segmentation of Point Clouds using Spectral Clustering", 2014, Algorithms 1 and 2, section 4.1).
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "segmentation/cloud_view.hpp"
#include "segmentation/options.hpp"
#include "segmentation/segmentation.hpp"

namespace cleave::segmentation {

// The steps of Segmenter::segment, in order; how the cloud is looked at is part of the first.
enum class Stage {
  voxelise,
  normals,
  supervoxels,
  graph,
  partition,
  clean_up,
  label_points,
  describe
};
[[nodiscard]] const char* to_string(Stage stage);

// Told when each stage ends, for benchmarks: this library has no clock.
class StageObserver {
 public:
  virtual ~StageObserver() = default;
  virtual void stage_ended(Stage stage) = 0;
};

// Owns its working memory and reuses it; one thread at a time. The result depends on the cloud and
// the options alone: not on the thread, the run, the machine's load, or what was segmented before.
class Segmenter {
 public:
  // Throws std::invalid_argument, naming the option, when one is out of its range, or set
  // although the algorithm or the representation does not read it (ignored_options).
  explicit Segmenter(const Options& options = {});
  ~Segmenter();
  Segmenter(Segmenter&&) noexcept;
  Segmenter& operator=(Segmenter&&) noexcept;

  // `labels` has cloud.size() elements; every one is written: 0 = no segment. On an outcome other
  // than `segmented` all are 0 and `result` is empty.
  [[nodiscard]] Outcome segment(const CloudView& cloud, std::span<std::uint16_t> labels,
                                Segmentation& result, StageObserver* observer = nullptr);

 private:
  struct Workspace;
  Options options_;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace cleave::segmentation
