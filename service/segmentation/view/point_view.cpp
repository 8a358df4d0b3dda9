#include "segmentation/view/point_view.hpp"

#include <Eigen/Geometry>

#include "segmentation/view/measured.hpp"

namespace cleave::segmentation {
namespace {

constexpr std::size_t few = 64;  // points: they tell nothing

Eigen::Vector3d vector(const std::array<double, 3>& v) {
  return {v[0], v[1], v[2]};
}

// Along z if that looks at the points, or else at their middle.
Eigen::Matrix3d axes_towards(const Eigen::Matrix3d& own, const Eigen::Vector3d& centre,
                             const SightedPoints& points) {
  if (points.behind(centre, own.row(2)) <= max_strays(points.size())) return own;
  const Eigen::Vector3d way = points.middle() - centre;
  if (!(way.norm() > 0)) return own;
  Eigen::Matrix3d axes;
  axes.row(2) = way.normalized();
  axes.row(0) = axes.row(2).unitOrthogonal();
  axes.row(1) = axes.row(2).cross(axes.row(0));
  return axes;
}

}  // namespace

View PointViewFinder::find(const CloudView& cloud, Viewpoint viewpoint) {
  points_.take(cloud);
  View view;
  view.one_viewpoint = viewpoint == Viewpoint::single;
  const Eigen::Vector3d origin = -vector(cloud.origin_m);
  const Eigen::Vector3d known =
      cloud.pose ? Eigen::Vector3d(vector(cloud.pose->position_m) + origin) : origin;
  view.centre = known;
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  if (cloud.pose) {
    const auto& [w, x, y, z] = cloud.pose->orientation;
    axes = Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix().transpose();
  }
  if (points_.size() == 0) return view;
  if (points_.size() < few && viewpoint == Viewpoint::automatic) {
    view.one_viewpoint = points_.behind(known, axes.row(2)) == 0;
  } else if (viewpoint == Viewpoint::automatic) {
    const Sight sight = points_.look_from(known);
    view.one_viewpoint = sight.angular_spread <= sight.metric_spread;
    if (!cloud.pose) {
      const Eigen::Vector3d above =
          points_.middle() + 10 * points_.extent_m() * Eigen::Vector3d::UnitZ();
      if (points_.look_from(above).hidden < sight.hidden) {
        view.centre = above;
        view.one_viewpoint = false;
      }
    }
  }
  if (viewpoint == Viewpoint::single || view.one_viewpoint) {
    axes = axes_towards(axes, view.centre, points_);
    if (viewpoint == Viewpoint::automatic) {
      view.one_viewpoint = points_.behind(view.centre, axes.row(2)) <= max_strays(points_.size());
    }
    if (view.one_viewpoint) view.axes = axes;
  }
  view.moved = !view.centre.isZero(0) || !view.axes.isIdentity(0);
  return view;
}

}  // namespace cleave::segmentation
