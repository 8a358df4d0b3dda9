// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/view/camera/camera_finder.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "segmentation/view/camera/camera_of_plane.hpp"

namespace cleave::segmentation {
namespace {

constexpr std::size_t min_pixels = 64;
constexpr double max_distance_extents = 50;  // of the camera: farther is an orthographic view

// Scales the projection so that its last row is the direction of view.
Camera turned_to(const std::vector<SampledPixel>& pixels, const Eigen::Vector3d& centre,
                 const Eigen::Matrix3d& projection) {
  Camera camera{centre, projection / projection.row(2).norm()};
  std::size_t behind = 0;
  for (const SampledPixel& p : pixels) {
    behind += camera.view().dot(p.point - centre) < 0 ? 1U : 0U;
  }
  if (2 * behind > pixels.size()) camera.projection = -camera.projection;
  return camera;
}

}  // namespace

Eigen::Vector2d CameraFinder::seen_at(const SampledPixel& pixel) const {
  return (Eigen::Vector2d(pixel.column, pixel.row) - scaling_.centre) / scaling_.size;
}

Eigen::Matrix3d CameraFinder::to_pixels() const {
  Eigen::Matrix3d matrix = Eigen::Vector3d(scaling_.size, scaling_.size, 1).asDiagonal();
  matrix.topRightCorner<2, 1>() = scaling_.centre;
  return matrix;
}

Camera CameraFinder::fit_from(const Pixels& part, const Eigen::Vector3d& centre) {
  from_centre_.clear();
  for (const SampledPixel& p : part) {
    const Eigen::Vector3d direction = p.point - centre;
    if (direction.squaredNorm() > 0) from_centre_.add(direction, seen_at(p));
  }
  return turned_to(part, centre, to_pixels() * from_centre_.solve());
}

std::optional<Camera> CameraFinder::fit_anywhere(const Pixels& part) {
  from_anywhere_.clear();
  for (const SampledPixel& p : part) {
    const Eigen::Vector3d point = (p.point - scaling_.middle) / scaling_.extent_m;
    from_anywhere_.add(point.homogeneous(), seen_at(p));
  }
  const Eigen::Matrix<double, 3, 4> map = from_anywhere_.solve();
  const Eigen::Matrix3d projection = map.leftCols<3>();
  const Eigen::Vector3d centre = -projection.inverse() * map.col(3);
  if (!(centre.norm() < max_distance_extents)) return std::nullopt;
  return turned_to(part, scaling_.middle + scaling_.extent_m * centre, to_pixels() * projection);
}

std::optional<Camera> CameraFinder::fit_to_plane(const Pixels& part) {
  constexpr double flat = 0.02;
  const ScenePlane plane = plane_through(part, scaling_.middle, scaling_.extent_m);
  if (!(plane.flatness < flat)) return std::nullopt;
  from_centre_.clear();
  for (const SampledPixel& p : part) {
    const Eigen::Vector3d point = plane.axes.transpose() * (p.point - scaling_.middle);
    from_centre_.add({point.x() / scaling_.extent_m, point.y() / scaling_.extent_m, 1}, seen_at(p));
  }
  Camera camera = camera_of_plane(from_centre_.solve());
  camera.centre.z() += plane.height;
  if (!(camera.centre.norm() < max_distance_extents)) return std::nullopt;
  return turned_to(part, scaling_.middle + scaling_.extent_m * (plane.axes * camera.centre),
                   to_pixels() * camera.projection * plane.axes.transpose());
}

bool CameraFinder::fits(const Camera& camera, const Pixels& all) {
  if (!camera.projection.allFinite() || !camera.centre.allFinite()) return false;
  columns_.start();
  rows_.start();
  std::size_t behind = 0;
  for (const SampledPixel& p : all) {
    const Eigen::Vector3d seen = camera.projection * (p.point - camera.centre);
    if (!(seen.z() > 0)) {
      ++behind;
      continue;
    }
    columns_.add(p.line, seen.x() / seen.z());
    rows_.add(p.level, seen.y() / seen.z());
  }
  constexpr std::size_t some = 200;  // one in so many may be a stray
  return behind <= all.size() / some && columns_.are_straight() && rows_.are_straight();
}

std::optional<Camera> CameraFinder::fit(const Pixels& part, const Pixels& all,
                                        std::span<const Eigen::Vector3d> centres) {
  if (part.size() < min_pixels) return std::nullopt;
  const auto is_sound = [&](const Camera& camera, bool square) {
    return has_sound_pixels(camera, square) && fits(camera, all);
  };
  for (const Eigen::Vector3d& centre : centres) {
    if (!((centre - scaling_.middle).norm() < max_distance_extents * scaling_.extent_m)) continue;
    const Camera camera = fit_from(part, centre);
    if (is_sound(camera, true)) return camera;
  }
  std::optional<Camera> anywhere = fit_anywhere(part);
  if (anywhere && is_sound(*anywhere, true)) return anywhere;
  std::optional<Camera> of_plane = fit_to_plane(part);
  if (of_plane && is_sound(*of_plane, true)) return of_plane;
  if (anywhere && !of_plane && is_sound(*anywhere, false)) return anywhere;
  return std::nullopt;
}

std::optional<Camera> CameraFinder::find(const PixelSample& sample, std::uint32_t width,
                                         std::uint32_t height,
                                         std::span<const Eigen::Vector3d> centres) {
  if (!(sample.extent_m() > 0)) return std::nullopt;
  const Eigen::Vector2d size(width, height);
  scaling_ = {.middle = sample.middle(),
              .extent_m = sample.extent_m(),
              .centre = (size - Eigen::Vector2d::Ones()) / 2,
              .size = size.maxCoeff()};
  const Pixels& all = sample.pixels();
  std::optional<Camera> camera = fit(all, all, centres);
  for (int half = 0; half < 4 && !camera; ++half) {
    const double sign = half % 2 == 0 ? 1 : -1;
    const Eigen::Index axis = half / 2;
    part_.clear();
    for (const SampledPixel& p : all) {
      if (sign * seen_at(p)[axis] > 0) part_.push_back(p);
    }
    camera = fit(part_, all, centres);
  }
  return camera;
}

}  // namespace cleave::segmentation
