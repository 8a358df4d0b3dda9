// SPDX-License-Identifier: BSD-3-Clause
// Finds the camera that took an organised cloud, in whatever frame its points are.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "segmentation/view/camera/camera.hpp"
#include "segmentation/view/camera/pixel_sample.hpp"
#include "segmentation/view/camera/projective_fit.hpp"
#include "segmentation/view/camera/straight_lines.hpp"

namespace cleave::segmentation {

class CameraFinder {
 public:
  // Tries `centres`, the likeliest first; then any; and, because a plane looks the same from many
  // places, the one whose image has its middle in the middle. If no camera fits, columns or rows
  // may be missing somewhere: then one is tried that fits a half of the image. Nothing where the
  // pixels of a column or of a row do not lie in a plane through the camera: no pinhole image.
  [[nodiscard]] std::optional<Camera> find(const PixelSample& sample, std::uint32_t width,
                                           std::uint32_t height,
                                           std::span<const Eigen::Vector3d> centres);

 private:
  using Pixels = std::vector<SampledPixel>;
  struct Scaling {  // to numbers that are about 1 large, as Hartley and Zisserman normalise
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    double extent_m = 1;
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();  // column, row
    double size = 1;                                   // pixels
  };
  [[nodiscard]] std::optional<Camera> fit(const Pixels& part, const Pixels& all,
                                          std::span<const Eigen::Vector3d> centres);
  [[nodiscard]] Camera fit_from(const Pixels& part, const Eigen::Vector3d& centre);
  [[nodiscard]] std::optional<Camera> fit_anywhere(const Pixels& part);
  [[nodiscard]] std::optional<Camera> fit_to_plane(const Pixels& part);
  [[nodiscard]] bool fits(const Camera& camera, const Pixels& all);
  [[nodiscard]] Eigen::Vector2d seen_at(const SampledPixel& pixel) const;
  [[nodiscard]] Eigen::Matrix3d to_pixels() const;  // from seen_at

  Scaling scaling_;
  ProjectiveFit<3> from_centre_;
  ProjectiveFit<4> from_anywhere_;
  StraightLines columns_, rows_;
  Pixels part_;
};

}  // namespace cleave::segmentation
