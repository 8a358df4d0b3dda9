// SPDX-License-Identifier: BSD-3-Clause
// From a URI to a source.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "recording/frames/gap_limit.hpp"
#include "recording/units/unit.hpp"
#include "sensor/sources/calibrated_source.hpp"
#include "sensor/sources/openni2/openni2_source.hpp"
#include "sensor/sources/source.hpp"

namespace cleave::sensor {

// How recordings are played.
struct Playback {
  bool loop = false;
  std::optional<recording::Unit> unit = {};          // of the points of pcd: and mcap:
  recording::GapLimit gaps = recording::GapLimit();  // of those with a timing of their own
};

// What is done to a source's frames.
struct Treatment {
  std::uint32_t decimate = 1;  // of an image, a block of so many pixels a side becomes one point
  Calibration calibration = {};
};

// openni2:[URI], synthetic:SCENE, pcd:PATH, oni:FILE, mcap:FILE[?topic=TOPIC]. `mode` is asked of
// cameras. An image that is decimated (Decimator) may have so many more points than the stream
// carries; its calibration comes first. Opens nothing. Throws
// std::invalid_argument, listing the sources, for any other URI.
[[nodiscard]] std::unique_ptr<Source> make_source(const std::string& uri, const VideoMode& mode,
                                                  const Playback& playback,
                                                  const Treatment& treatment = {});

}  // namespace cleave::sensor
