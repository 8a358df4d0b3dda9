// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/view/image_view.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <span>

#include "segmentation/view/vector_of.hpp"

namespace cleave::segmentation {
namespace {

// Which way is down in an image? The image does not tell: it may be stored in any order. Where the
// camera looks along z, forward or back, as cameras do in their own frames, y is vertical (down, or
// up as in OpenGL); else z is up, as for robots and in maps.
Eigen::Vector3d down_of_frame(const Eigen::Vector3d& view) {
  constexpr double along = 0.7;
  if (view.z() > along) return Eigen::Vector3d::UnitY();
  if (view.z() < -along) return -Eigen::Vector3d::UnitY();
  return -Eigen::Vector3d::UnitZ();
}

View upright_view(const Camera& camera) {
  const Eigen::Vector3d down = down_of_frame(camera.view());
  const double by_row = camera.down().normalized().dot(down);
  const double by_column = camera.right().normalized().dot(down);
  View view;
  view.one_viewpoint = view.moved = true;
  view.centre = camera.centre;
  view.order.transposed = std::abs(by_column) > std::abs(by_row);
  Eigen::Vector3d y = (view.order.transposed ? camera.right() : camera.down()).normalized();
  const bool against_y = y.dot(down) < 0;
  if (against_y) y = -y;
  const Eigen::Vector3d x = y.cross(camera.view());
  const bool against_x = x.dot(view.order.transposed ? camera.down() : camera.right()) < 0;
  view.order.columns_reversed = view.order.transposed ? against_y : against_x;
  view.order.rows_reversed = view.order.transposed ? against_x : against_y;
  view.axes.row(0) = x;
  view.axes.row(1) = y;
  view.axes.row(2) = camera.view();
  return view;
}

}  // namespace

std::optional<View> ImageViewFinder::find(const CloudView& cloud) {
  if (!cloud.organised()) return std::nullopt;
  sample_.take(cloud);
  const Eigen::Vector3d origin = vector_of(cloud.origin_m);
  const auto own = origin.isZero(0) ? own_frame_.find(sample_.pixels()) : std::nullopt;
  View in_own_frame;
  in_own_frame.one_viewpoint = true;
  if (own) in_own_frame.order = own->order;
  if (own && own->exact) return in_own_frame;

  if (!sample_.pixels().empty()) {
    sample_.find_middle();
    std::array<Eigen::Vector3d, 2> centres = {-origin, -origin};
    if (cloud.pose) centres[0] += vector_of(cloud.pose->position_m);
    const auto tried = std::span(centres).first(cloud.pose ? 2 : 1);
    if (const auto camera = camera_.find(sample_, cloud.width, cloud.height, tried)) {
      return upright_view(*camera);
    }
  }
  return own ? std::optional(in_own_frame) : std::nullopt;
}

}  // namespace cleave::segmentation
