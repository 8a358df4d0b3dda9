#include "segmentation/edge_heuristics.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace cleave::segmentation {
namespace {

float cos_angle(const Surfel& i, const Surfel& j) {
  return std::clamp(i.normal.dot(j.normal), -1.0F, 1.0F);
}

}  // namespace

bool is_convex(const Surfel& i, const Surfel& j) {
  return (j.normal - i.normal).dot(j.position - i.position) > 0;
}

float concave_weight(float cos_angle, float sigma) {
  return 1 / (1 + sigma * (2 - 2 * cos_angle));
}

float edge_weight(const Surfel& i, const Surfel& j, const GraphOptions& options) {
  return is_convex(i, j) ? 1 : concave_weight(cos_angle(i, j), options.weight_sigma);
}

float meeting_angle_rad(const Surfel& i, const Surfel& j) {
  constexpr float min_sine = 1e-6F;
  const Eigen::Vector3f s = i.normal.cross(j.normal);
  const Eigen::Vector3f d = j.position - i.position;
  const float lengths = s.norm() * d.norm();
  if (s.norm() < min_sine || !(lengths > 0)) return std::numbers::pi_v<float> / 2;
  return std::acos(std::min(std::abs(s.dot(d)) / lengths, 1.0F));
}

float least_meeting_angle_rad(float beta_rad, const GraphOptions& options) {
  return options.validity_max_rad /
         (1 + std::exp(-options.validity_slope * (beta_rad - options.validity_offset_rad)));
}

bool is_valid(const Surfel& i, const Surfel& j, const GraphOptions& options) {
  const float beta_rad = std::acos(cos_angle(i, j));
  return meeting_angle_rad(i, j) > least_meeting_angle_rad(beta_rad, options);
}

bool is_cannot_link(float weight, const GraphOptions& options) {
  return weight < concave_weight(std::cos(options.cannot_link_rad), options.weight_sigma);
}

}  // namespace cleave::segmentation
