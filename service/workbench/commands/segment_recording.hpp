// SPDX-License-Identifier: BSD-3-Clause
// `cleave segment` of a recording: one labelled PCD file a frame.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "recording/pcd/cloud.hpp"
#include "recording/units/unit.hpp"
#include "segmentation/cloud_view.hpp"
#include "segmentation/options.hpp"

namespace cleave::workbench {

struct RecordingToSegment {
  std::string input;   // a recording, perhaps with ?topic=
  std::string output;  // a folder for all frames
  bool json = false;
  std::optional<recording::Unit> unit;  // of its points; without one, millimetres are refused
  std::optional<segmentation::SensorPose> pose;  // where the sensor stood; else as the points tell
  segmentation::Options options;
};

// Writes frame_000001.pcd, ..., in metres, into the folder `output`, which must not exist; frames
// that cannot be read or segmented are named and counted. Returns the program's exit code: 1 where
// there were any, or no frame. Throws what recording::open_frame_source() and its source throw.
[[nodiscard]] int segment_recording(const RecordingToSegment& recording);

// One frame of a recording, from 1, in metres. Throws as above, and std::runtime_error where it is
// not there.
[[nodiscard]] recording::PcdCloud frame_of_recording(const std::string& input,
                                                     std::optional<recording::Unit> unit,
                                                     std::uint64_t number);

}  // namespace cleave::workbench
