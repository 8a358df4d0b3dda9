// SPDX-License-Identifier: BSD-3-Clause
// What cleave-segmenter can be told, but for the segmentation itself, whose options belong to
// service/segmentation. The file as shipped is segmenter.yaml; it holds these defaults.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "config/section.hpp"
#include "config/stream_config.hpp"

namespace cleave::config {

// Workers of a sensor. Each holds a loan of the label maps' writer, which has 8: more would leave
// none for a frame that waits for a slower one before it.
inline constexpr std::uint32_t max_workers = 6;

struct SegmenterConfig {
  std::vector<std::string> sensors = {"camera"};  // whose clouds are segmented, each name once
  std::uint32_t workers = 0;  // 1 to max_workers frames of a sensor at a time; 0 = cores less one
  std::uint32_t queue = 2;    // 1 to 8 frames that may wait for a worker
  Mode mode = Mode::live;
  bool check_unit = true;  // reject clouds that seem to be in millimetres
  StreamConfig stream;
};

// Reads all but the section `segmentation`, which is the caller's to bind:
//   Section file = Section::load(path);
//   SegmenterConfig config = read_segmenter_config(file);
//   Section segmentation = file.section("segmentation");  // ... its getters ...
//   file.finish();
// Throws ConfigurationError.
[[nodiscard]] SegmenterConfig read_segmenter_config(Section& file);

// Workers to start: `workers`, or where that is 0 one less than `cores`, within 1 to max_workers.
[[nodiscard]] std::uint32_t worker_count(const SegmenterConfig& config, std::uint32_t cores);

}  // namespace cleave::config
