// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/view/point_view.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "segmentation/view/measured.hpp"
#include "segmentation/view/vector_of.hpp"

namespace cleave::segmentation {
namespace {

constexpr std::size_t few = 64;  // points: they tell nothing
constexpr double far = 20;       // extents of the cloud: as if from infinity

Eigen::Matrix3d axes_of(const SensorPose& pose) {
  const auto& [w, x, y, z] = pose.orientation;
  return Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix().transpose();
}

bool all_in_front(const SightedPoints& points, const View& view) {
  return points.behind(view.centre, view.axes.row(2)) <= max_strays(points.size());
}

// Where the view's own axes look past the points: towards their middle.
void turn_to(const SightedPoints& points, View& view) {
  const Eigen::Vector3d way = points.middle() - view.centre;
  if (all_in_front(points, view) || !(way.norm() > 0)) return;
  const Eigen::Vector3d z = way.normalized();
  const Eigen::Vector3d x = z.unitOrthogonal();
  view.axes.row(0) = x;
  view.axes.row(1) = z.cross(x);
  view.axes.row(2) = z;
}

}  // namespace

bool PointViewFinder::is_sampled_from(const View& view, const Sight& sight) const {
  if (points_.size() < few) return all_in_front(points_, view);
  return sight.angular_spread <= sight.metric_spread &&
         (view.centre - points_.middle()).norm() < far * points_.extent_m();
}

Eigen::Vector3d PointViewFinder::likely_place(const Eigen::Vector3d& origin, const Sight& sight) {
  constexpr double some = 0.02;
  if (points_.size() < few || !(points_.extent_m() > 0)) return origin;
  const double distance = (origin - points_.middle()).norm() / points_.extent_m();
  Eigen::Vector3d above =
      points_.middle() + far / 2 * points_.extent_m() * Eigen::Vector3d::UnitZ();
  if (!(distance < far)) return above;
  const double hidden = points_.share_hidden(origin, sight.spacing_rad);
  if (hidden <= some) return origin;
  const double spacing_rad = points_.look_from(above).spacing_rad;
  return points_.share_hidden(above, spacing_rad) < hidden ? above : origin;
}

View PointViewFinder::find(const CloudView& cloud, Viewpoint viewpoint) {
  points_.take(cloud);
  const Eigen::Vector3d origin = -vector_of(cloud.origin_m);
  View view;
  view.centre = origin;
  if (cloud.pose) {
    view.centre += vector_of(cloud.pose->position_m);
    view.axes = axes_of(*cloud.pose);
  }
  view.one_viewpoint = viewpoint == Viewpoint::single;
  if (viewpoint == Viewpoint::automatic && points_.size() > 0) {
    const Sight sight = points_.look_from(view.centre);
    view.one_viewpoint = is_sampled_from(view, sight);
    if (view.one_viewpoint) {
      turn_to(points_, view);
      view.one_viewpoint = all_in_front(points_, view);
    } else if (!cloud.pose) {
      view.centre = likely_place(origin, sight);
    }
  } else if (view.one_viewpoint && cloud.pose) {
    turn_to(points_, view);
  }
  if (!view.one_viewpoint) view.axes.setIdentity();
  view.moved = !view.centre.isZero(0) || !view.axes.isIdentity(0);
  return view;
}

}  // namespace cleave::segmentation
