// SPDX-License-Identifier: BSD-3-Clause
// A recording's frames, whoever recorded it: the one way in for all who need no more than clouds.
#pragma once

#include <memory>
#include <set>
#include <string>

#include "recording/frames/frame_input.hpp"
#include "recording/ros/file_topic.hpp"

namespace cleave::recording {

// With a topic, the clouds of that topic; without one, the clouds of `cleave record` where there
// are any, else those of the only topic that can be segmented. `kinds` are wanted of recordings of
// `cleave record`; others have clouds alone, and `sensor` is their sensor's name.
// Throws FileError: the file cannot be opened or is no MCAP; no topic or several can be segmented,
// and none was named; the one that was named is not there or cannot be. It lists topics and
// reasons.
[[nodiscard]] std::unique_ptr<FrameInput> open_frames(const FileTopic& from,
                                                      const std::set<Kind>& kinds,
                                                      const std::string& sensor = "camera");

}  // namespace cleave::recording
