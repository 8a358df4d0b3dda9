// SPDX-License-Identifier: BSD-3-Clause
#include "recording/ros/camera.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "recording/ros/unusable.hpp"

namespace cleave::recording::ros {
namespace {

struct Pinhole {
  double fx;
  double fy;
  double cx;
  double cy;
  [[nodiscard]] bool is_set() const {
    constexpr double most = std::numeric_limits<float>::max();
    return fx > 0 && fy > 0 && fx <= most && fy <= most && std::fabs(cx) <= most &&
           std::fabs(cy) <= most;
  }
};

// Throws Unusable.
Pinhole pinhole_of(const CameraInfo& info, ImageKind kind) {
  const Pinhole k{info.k[0], info.k[4], info.k[2], info.k[5]};
  const Pinhole p{info.p[0], info.p[5], info.p[2], info.p[6]};
  const Pinhole& first = kind == ImageKind::raw ? k : p;
  const Pinhole& second = kind == ImageKind::raw ? p : k;
  if (first.is_set()) return first;
  if (second.is_set()) return second;
  throw Unusable("no calibration",
                 "its CameraInfo has no focal length in K or P: the camera was not calibrated");
}

// Throws Unusable.
void check_size(const CameraInfo& info, std::uint32_t width, std::uint32_t height) {
  const auto expected = [](std::uint32_t all, std::uint32_t region, std::uint32_t binning) {
    return (region > 0 ? region : all) / std::max(1U, binning);
  };
  const std::uint32_t columns = expected(info.width, info.roi_width, info.binning_x);
  const std::uint32_t rows = expected(info.height, info.roi_height, info.binning_y);
  if ((info.width == 0 && info.height == 0) || (columns == width && rows == height)) return;
  throw Unusable("CameraInfo of another size",
                 "its CameraInfo is of " + std::to_string(columns) + " x " + std::to_string(rows) +
                     " pixels, the image has " + std::to_string(width) + " x " +
                     std::to_string(height));
}

bool is_distorted(const CameraInfo& info) {
  return std::ranges::any_of(info.d, [](double coefficient) { return coefficient != 0; });
}

}  // namespace

ImageKind kind_of(const std::string& image_topic) {
  const std::string name = image_topic.substr(image_topic.rfind('/') + 1);
  return name.find("rect") == std::string::npos ? ImageKind::raw : ImageKind::rectified;
}

Camera camera_of(const CameraInfo& info, ImageKind kind, std::uint32_t width,
                 std::uint32_t height) {
  const Pinhole whole = pinhole_of(info, kind);
  check_size(info, width, height);
  const double binning_x = std::max(1U, info.binning_x);
  const double binning_y = std::max(1U, info.binning_y);
  Camera camera;
  camera.intrinsics = {static_cast<float>(whole.fx / binning_x),
                       static_cast<float>(whole.fy / binning_y),
                       static_cast<float>((whole.cx - info.roi_x) / binning_x),
                       static_cast<float>((whole.cy - info.roi_y) / binning_y)};
  if (kind == ImageKind::raw && is_distorted(info)) {
    camera.remark = "the distortion of its lens (" + info.distortion_model +
                    ") is not taken back; a rectified topic is more exact";
  }
  return camera;
}

}  // namespace cleave::recording::ros
