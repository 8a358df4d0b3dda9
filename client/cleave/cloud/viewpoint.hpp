// Where the sensor stood, as PCD files and the command line write it.
#pragma once

#include <optional>
#include <stdexcept>
#include <string_view>

#include "segmentation/cloud_view.hpp"

namespace cleave::client {

class ViewpointError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A PCD header's VIEWPOINT: translation and quaternion w x y z. Nothing for 0 0 0 1 0 0 0: that is
// what everyone writes who does not know it, and what it says where it is true changes nothing.
[[nodiscard]] std::optional<segmentation::SensorPose> pose_of_header(std::string_view viewpoint);

// "X,Y,Z" or "X,Y,Z,QW,QX,QY,QZ". Throws ViewpointError with what was expected.
[[nodiscard]] segmentation::SensorPose parse_viewpoint(std::string_view text);

}  // namespace cleave::client
