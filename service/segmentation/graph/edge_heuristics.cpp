// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/graph/edge_heuristics.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "segmentation/math/portable_math.hpp"

namespace cleave::segmentation {
namespace {

float cos_angle(const Surfel& i, const Surfel& j) {
  return std::clamp(i.normal.dot(j.normal), -1.0F, 1.0F);
}

}  // namespace

bool is_convex(const Surfel& i, const Surfel& j) {
  return (j.normal - i.normal).dot(j.position - i.position) > 0;
}

bool is_convex_after_lai(const Surfel& i, const Surfel& j) {
  const Eigen::Vector3f d = j.position - i.position;
  return (d - d.dot(i.normal) * i.normal).dot(j.normal) > 0;
}

bool is_convex(const Surfel& i, const Surfel& j, Convexity convexity) {
  return convexity == Convexity::lai ? is_convex_after_lai(i, j) : is_convex(i, j);
}

float concave_weight(float cos_angle, const GraphOptions& options) {
  const float squared_difference = 2 - 2 * cos_angle;
  if (options.weight == WeightFunction::gaussian) {
    return static_cast<float>(
        portable::exp(-double{squared_difference} / double{options.weight_sigma}));
  }
  return 1 / (1 + options.weight_sigma * squared_difference);
}

float edge_weight(const Surfel& i, const Surfel& j, const GraphOptions& options) {
  return is_convex(i, j, options.convexity) ? 1 : concave_weight(cos_angle(i, j), options);
}

float meeting_angle_rad(const Surfel& i, const Surfel& j) {
  constexpr float min_sine = 1e-6F;
  const Eigen::Vector3f s = i.normal.cross(j.normal);
  const Eigen::Vector3f d = j.position - i.position;
  const float lengths = s.norm() * d.norm();
  if (s.norm() < min_sine || !(lengths > 0)) return std::numbers::pi_v<float> / 2;
  return static_cast<float>(portable::acos(std::min(std::abs(s.dot(d)) / lengths, 1.0F)));
}

float least_meeting_angle_rad(float beta_rad, const GraphOptions& options) {
  const float exponent = -options.validity_slope * (beta_rad - options.validity_offset_rad);
  return static_cast<float>(options.validity_max_rad / (1 + portable::exp(exponent)));
}

bool is_valid(const Surfel& i, const Surfel& j, const GraphOptions& options) {
  const auto beta_rad = static_cast<float>(portable::acos(cos_angle(i, j)));
  return meeting_angle_rad(i, j) > least_meeting_angle_rad(beta_rad, options);
}

float step_m(const Surfel& i, const Surfel& j) {
  return std::abs((i.normal + j.normal).dot(j.position - i.position)) / 2;
}

bool is_step(const Surfel& i, const Surfel& j, const GraphOptions& options) {
  if (!(options.max_step_m > 0)) return false;
  const float depth_m = (i.position.z() + j.position.z()) / 2;
  const float off_m = step_m(i, j) - options.max_step_m * depth_m * depth_m;
  if (!(off_m > 0)) return false;
  const float sine_of_half_angle = std::sqrt((1 - cos_angle(i, j)) / 2);
  const float by_crease_m = sine_of_half_angle * (j.position - i.position).norm() / 2;
  return off_m > by_crease_m;
}

float cannot_link_share(float beta_rad, const GraphOptions& options) {
  constexpr float steps = 64;
  const float range_rad = options.cannot_link_rad - options.soft_cannot_link_rad;
  if (!(range_rad > 0)) return 0;
  const float share = std::clamp((beta_rad - options.soft_cannot_link_rad) / range_rad, 0.0F, 1.0F);
  return std::floor(share * steps) / steps;
}

float cannot_link_weight(const GraphOptions& options) {
  const auto least_cosine = static_cast<float>(portable::cos(options.cannot_link_rad));
  return concave_weight(least_cosine, options);
}

}  // namespace cleave::segmentation
