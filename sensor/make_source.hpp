// From a URI to a source.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "recording/units/unit.hpp"
#include "sensor/openni2_source.hpp"
#include "sensor/source.hpp"

namespace cleave::sensor {

// openni2:[URI], synthetic:SCENE, pcd:PATH, oni:FILE, mcap:FILE. `mode` is asked of cameras; `loop`
// is for recordings, `unit` for those that are of points: pcd and mcap. Opens nothing. Throws
// std::invalid_argument, listing the sources, for any other URI.
[[nodiscard]] std::unique_ptr<Source> make_source(const std::string& uri, const VideoMode& mode,
                                                  bool loop,
                                                  std::optional<recording::Unit> unit = {});

}  // namespace cleave::sensor
