// SPDX-License-Identifier: BSD-3-Clause
// Labels and segments that are known to be right, and how others differ from them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "idl/frame_key.hpp"
#include "recording/frames/frame_reader.hpp"
#include "workbench/verification/offline_segmenter.hpp"

namespace cleave::workbench {

// 0 = exactly equal.
struct Tolerances {
  double points_share = 0;  // of a frame's points that may have another label
  double distance_m = 0;    // by which a centroid or a box may be off
  [[nodiscard]] bool exact() const { return points_share <= 0 && distance_m <= 0; }
};

// What is known of a frame: a recording may hold either or both.
struct GoldenFrame {
  std::optional<recording::Labels> labels;
  std::optional<recording::SegmentList> list;
};

// A line for everything that differs, for people; empty if nothing does. With a tolerance only
// labels, point counts, centroids and boxes are looked at: all else follows from the points.
[[nodiscard]] std::vector<std::string> differences(const GoldenFrame& expected,
                                                   const SegmentedCloud& found,
                                                   const Tolerances& tolerances);

// Read as far as it is asked for.
class GoldenFrames {
 public:
  explicit GoldenFrames(const std::filesystem::path& file);

  // The frame of this cloud, once; empty if there is none.
  [[nodiscard]] std::optional<GoldenFrame> take(const recording::FrameHeader& cloud);
  // How many frames nobody has asked for. Reads to the end.
  [[nodiscard]] std::size_t left();
  [[nodiscard]] std::vector<std::string> problems() const { return reader_.problems(); }

 private:
  using Key = std::pair<std::string, FrameKey>;
  [[nodiscard]] static Key place_of(const recording::FrameHeader& header);
  bool read_one();

  recording::FrameReader reader_;
  std::map<Key, GoldenFrame> waiting_;
};

}  // namespace cleave::workbench
