// From a URI to a source.
#pragma once

#include <memory>
#include <string>

#include "recording/frames/gap_limit.hpp"
#include "sensor/openni2_source.hpp"
#include "sensor/source.hpp"

namespace cleave::sensor {

// openni2:[URI], synthetic:SCENE, pcd:PATH, oni:FILE, mcap:FILE[?topic=TOPIC]. `mode` is asked of
// cameras; `loop` is for recordings, `gaps` for those with a timing of their own. Opens nothing.
// Throws std::invalid_argument, listing the sources, for any other URI.
[[nodiscard]] std::unique_ptr<Source> make_source(const std::string& uri, const VideoMode& mode,
                                                  bool loop,
                                                  recording::GapLimit gaps = recording::GapLimit());

}  // namespace cleave::sensor
