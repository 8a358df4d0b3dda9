// SPDX-License-Identifier: BSD-3-Clause
// A recording through the segmentation, against what is known to be right.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "recording/ros/file_topic.hpp"
#include "workbench/verification/golden.hpp"

namespace cleave::workbench {

struct FrameDifference {
  recording::FrameHeader header;
  std::vector<std::string> lines;
};

struct VerificationResult {
  std::size_t frames = 0;  // clouds of the recording
  std::size_t different = 0;
  std::size_t not_expected = 0;       // clouds that the golden recording does not know
  std::size_t missing = 0;            // frames of the golden recording without a cloud
  std::vector<std::string> problems;  // what could not be read of the files
  [[nodiscard]] bool passed() const {
    return frames > 0 && different + not_expected + missing == 0 && problems.empty();
  }
};

// Segments every cloud of `input`, and tells of each frame that differs. `on_progress` is told how
// many frames are done. Throws recording::FileError.
[[nodiscard]] VerificationResult verify(
    const recording::FileTopic& input, const std::filesystem::path& golden,
    OfflineSegmenter& segmenter, const Tolerances& tolerances,
    const std::function<void(const FrameDifference&)>& on_difference,
    const std::function<void(std::size_t)>& on_progress);

// Segments every cloud of `input` and writes labels and segments to `golden`, which appears whole
// or not at all. The same clouds make the same file. Returns the number of frames. Throws
// recording::FileError: nothing was segmented, or a cloud could not be read.
std::size_t write_golden(const recording::FileTopic& input, const std::filesystem::path& golden,
                         OfflineSegmenter& segmenter,
                         const std::function<void(std::size_t)>& on_progress);

}  // namespace cleave::workbench
