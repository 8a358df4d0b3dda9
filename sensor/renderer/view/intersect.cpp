// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/renderer/view/intersect.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cleave::render {
namespace {

// Nearer hits are those of the surface that the ray leaves.
constexpr double smallest_t = 1e-7;

enum class Side { outer, inner };

void keep_nearer(double t, const Eigen::Vector3d& normal, Part part, Hit& nearest) {
  if (t > smallest_t && t < nearest.t) nearest = {t, normal, part};
}

// Solutions of |q + t d|^2 = r^2 with the squares and products given; the ray enters a surface at
// the first (outer side) and leaves it at the second (inner side).
double quadratic_root(double dd, double qd, double qq_minus_rr, Side side) {
  const double discriminant = qd * qd - dd * qq_minus_rr;
  if (!(discriminant >= 0) || dd <= 0) return -1;
  const double root = std::sqrt(discriminant);
  return (-qd + (side == Side::outer ? -root : root)) / dd;
}

// The wall of a cylinder about z.
void wall(const Ray& ray, double radius, double z_low, double z_high, Side side, Part part,
          Hit& nearest) {
  const Eigen::Vector2d q = ray.origin.head<2>();
  const Eigen::Vector2d d = ray.direction.head<2>();
  const double t =
      quadratic_root(d.squaredNorm(), q.dot(d), q.squaredNorm() - radius * radius, side);
  const double z = ray.origin.z() + t * ray.direction.z();
  if (t <= 0 || z < z_low || z > z_high) return;
  const Eigen::Vector2d outward = (q + t * d) / radius;
  const double sign = side == Side::outer ? 1 : -1;
  keep_nearer(t, {sign * outward.x(), sign * outward.y(), 0}, part, nearest);
}

// A flat ring (a disc with `inner_radius` 0) about z.
void ring(const Ray& ray, double z, double inner_radius, double outer_radius, Part part,
          Hit& nearest) {
  if (ray.direction.z() == 0) return;
  const double t = (z - ray.origin.z()) / ray.direction.z();
  const double rr = (ray.origin + t * ray.direction).head<2>().squaredNorm();
  if (rr < inner_radius * inner_radius || rr > outer_radius * outer_radius) return;
  keep_nearer(t, {0, 0, ray.direction.z() > 0 ? -1.0 : 1.0}, part, nearest);
}

// The zone of a sphere about (0, 0, centre_z) between two heights.
void zone(const Ray& ray, double centre_z, double radius, double z_low, double z_high, Side side,
          Part part, Hit& nearest) {
  const Eigen::Vector3d q = ray.origin - Eigen::Vector3d(0, 0, centre_z);
  const double t = quadratic_root(ray.direction.squaredNorm(), q.dot(ray.direction),
                                  q.squaredNorm() - radius * radius, side);
  const double z = ray.origin.z() + t * ray.direction.z();
  if (t <= 0 || z < z_low || z > z_high) return;
  const Eigen::Vector3d outward = (q + t * ray.direction) / radius;
  keep_nearer(t, side == Side::outer ? outward : Eigen::Vector3d(-outward), part, nearest);
}

// A bar with round ends from a to b.
void capsule(const Ray& ray, const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius,
             Part part, Hit& nearest) {
  const Eigen::Vector3d axis = b - a;
  const double length2 = axis.squaredNorm();
  const Eigen::Vector3d q = ray.origin - a;
  const double q_along = q.dot(axis) / length2;
  const double d_along = ray.direction.dot(axis) / length2;
  const Eigen::Vector3d q_across = q - q_along * axis;
  const Eigen::Vector3d d_across = ray.direction - d_along * axis;
  const double t = quadratic_root(d_across.squaredNorm(), q_across.dot(d_across),
                                  q_across.squaredNorm() - radius * radius, Side::outer);
  const double along = q_along + t * d_along;
  if (t > 0 && along >= 0 && along <= 1) {
    keep_nearer(t, (q_across + t * d_across) / radius, part, nearest);
  }
  for (const Eigen::Vector3d& end : {a, b}) {
    const Eigen::Vector3d from_end = ray.origin - end;
    const double t_end = quadratic_root(ray.direction.squaredNorm(), from_end.dot(ray.direction),
                                        from_end.squaredNorm() - radius * radius, Side::outer);
    keep_nearer(t_end, (from_end + t_end * ray.direction) / radius, part, nearest);
  }
}

// The slabs of Kay and Kajiya. Entered from outside only.
void block(const Ray& ray, const Eigen::Vector3d& low, const Eigen::Vector3d& high, Hit& nearest) {
  double t_in = -std::numeric_limits<double>::infinity();
  double t_out = std::numeric_limits<double>::infinity();
  int entered = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double d = ray.direction[axis];
    if (d == 0) {
      if (ray.origin[axis] < low[axis] || ray.origin[axis] > high[axis]) return;
      continue;
    }
    double t_first = (low[axis] - ray.origin[axis]) / d;
    double t_second = (high[axis] - ray.origin[axis]) / d;
    if (t_first > t_second) std::swap(t_first, t_second);
    if (t_first > t_in) {
      t_in = t_first;
      entered = axis;
    }
    t_out = std::min(t_out, t_second);
  }
  if (t_in > t_out) return;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  normal[entered] = ray.direction[entered] > 0 ? -1 : 1;
  keep_nearer(t_in, normal, outside_part, nearest);
}

void closed_cylinder(const Ray& ray, double radius, double height, Hit& nearest) {
  wall(ray, radius, 0, height, Side::outer, outside_part, nearest);
  ring(ray, height, 0, radius, outside_part, nearest);
  ring(ray, 0, 0, radius, outside_part, nearest);
}

struct IntersectShape {
  const Ray& ray;
  Hit& nearest;

  void operator()(const Box& s) const {
    block(ray, {-s.half_m.x(), -s.half_m.y(), 0}, {s.half_m.x(), s.half_m.y(), 2 * s.half_m.z()},
          nearest);
  }
  void operator()(const Cylinder& s) const {
    closed_cylinder(ray, s.radius_m, s.height_m, nearest);
  }
  void operator()(const LyingCylinder& s) const {
    // In the frame (y, z, x) with the origin in the centre of one end it stands upright.
    const auto upright = [](const Eigen::Vector3d& v) {
      return Eigen::Vector3d(v.y(), v.z(), v.x());
    };
    const Ray turned{upright(ray.origin) + Eigen::Vector3d(0, -s.radius_m, s.half_length_m),
                     upright(ray.direction)};
    Hit hit;
    hit.t = nearest.t;
    closed_cylinder(turned, s.radius_m, 2 * s.half_length_m, hit);
    keep_nearer(hit.t, {hit.normal.z(), hit.normal.x(), hit.normal.y()}, outside_part, nearest);
  }
  void operator()(const Sphere& s) const {
    zone(ray, s.radius_m, s.radius_m, 0, 2 * s.radius_m, Side::outer, outside_part, nearest);
  }
  void operator()(const Bowl& s) const {
    const double inner_radius = s.radius_m - s.wall_m;
    const auto radius_at = [&s](double sphere_radius, double z) {
      const double dz = z - s.centre_height_m;
      return std::sqrt(std::max(0.0, sphere_radius * sphere_radius - dz * dz));
    };
    zone(ray, s.centre_height_m, s.radius_m, 0, s.height_m, Side::outer, outside_part, nearest);
    ring(ray, 0, 0, radius_at(s.radius_m, 0), outside_part, nearest);
    ring(ray, s.height_m, radius_at(inner_radius, s.height_m), radius_at(s.radius_m, s.height_m),
         outside_part, nearest);
    zone(ray, s.centre_height_m, inner_radius, s.wall_m, s.height_m, Side::inner, hollow_part,
         nearest);
    ring(ray, s.wall_m, 0, radius_at(inner_radius, s.wall_m), hollow_part, nearest);
  }
  void operator()(const Mug& s) const {
    const double inner_radius = s.radius_m - s.wall_m;
    wall(ray, s.radius_m, 0, s.height_m, Side::outer, outside_part, nearest);
    ring(ray, 0, 0, s.radius_m, outside_part, nearest);
    ring(ray, s.height_m, inner_radius, s.radius_m, outside_part, nearest);
    wall(ray, inner_radius, s.wall_m, s.height_m, Side::inner, hollow_part, nearest);
    ring(ray, s.wall_m, 0, inner_radius, floor_part, nearest);
    if (s.handle) handle(s);
  }

  void handle(const Mug& s) const {
    const auto points = handle_polyline(s);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      capsule(ray, points[i], points[i + 1], handle_bar_radius_m, handle_part, nearest);
    }
  }
};

}  // namespace

void intersect(const Shape& shape, const Ray& ray, Hit& nearest) {
  std::visit(IntersectShape{ray, nearest}, shape);
}

}  // namespace cleave::render
