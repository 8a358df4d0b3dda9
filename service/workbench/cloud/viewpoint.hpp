// SPDX-License-Identifier: BSD-3-Clause
// Where the sensor stood, as the command line says it.
#pragma once

#include <stdexcept>
#include <string_view>

#include "segmentation/cloud_view.hpp"

namespace cleave::workbench {

class ViewpointError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// "X,Y,Z" or "X,Y,Z,QW,QX,QY,QZ". Throws ViewpointError with what was expected.
[[nodiscard]] segmentation::SensorPose parse_viewpoint(std::string_view text);

}  // namespace cleave::workbench
