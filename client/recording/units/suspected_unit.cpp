// SPDX-License-Identifier: BSD-3-Clause
#include "recording/units/suspected_unit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "recording/cloud/measured.hpp"
#include "recording/percentile.hpp"
#include "recording/units/nearest_spacing.hpp"

namespace cleave::recording {
namespace {

constexpr std::size_t min_points = 200;
constexpr double nearest = 100;       // of measured depths
constexpr double nearest_whole = 20;  // where they are whole numbers
constexpr double most = 0.999;
constexpr double max_ratio = 2.75;  // tan 70 degrees
constexpr double alike = 1.15;      // spread of a lens-distorted image's pixels
constexpr double rounded = 1.6;     // the same, of coordinates that are whole numbers
constexpr double least_step = 0.1;  // from a pixel to the next

struct Point {
  float x, y, z;
  [[nodiscard]] bool measured() const {
    const std::array<float, 3> xyz = {x, y, z};
    return is_measured(xyz.data());
  }
  [[nodiscard]] bool in_view() const {
    return z > 0 && std::abs(x) < max_ratio * z && std::abs(y) < max_ratio * z;
  }
};

bool is_whole(float value) {
  return value == std::round(value);
}

std::vector<Point> measured_points(std::span<const float> xyz) {
  std::vector<Point> points;
  points.reserve(xyz.size() / 3);
  for (std::size_t i = 0; i + 3 <= xyz.size(); i += 3) {
    const Point p{xyz[i], xyz[i + 1], xyz[i + 2]};
    if (p.measured()) points.push_back(p);
  }
  return points;
}

template <class Predicate>
double share_of(const std::vector<Point>& points, Predicate&& predicate) {
  return static_cast<double>(std::ranges::count_if(points, predicate)) /
         static_cast<double>(points.size());
}

double depth_percentile(const std::vector<Point>& points, double share) {
  std::vector<float> depth;
  depth.reserve(points.size());
  for (const Point& p : points) depth.push_back(p.z);
  return percentile(depth, share);
}

// A look at a few points settles it for nearly all clouds in metres.
bool may_be_far(std::span<const float> xyz) {
  constexpr std::size_t few = 1000;
  const std::size_t step = xyz.size() / 3 / few + 1;
  std::size_t measured = 0;
  std::size_t far = 0;
  for (std::size_t i = 0; i + 3 <= xyz.size(); i += 3 * step) {
    const Point p{xyz[i], xyz[i + 1], xyz[i + 2]};
    if (!p.measured()) continue;
    ++measured;
    if (p.in_view() && p.z > nearest_whole) ++far;
  }
  // Too few were measured where it looked: they may lie elsewhere.
  return measured < few / 10 || 10 * far > 9 * measured;
}

struct Image {
  double pitch;  // of a pixel, in x/z
  bool is_camera;
};

Image image_of(const std::vector<Point>& points, double max_spread) {
  std::vector<PlanePoint> seen, flat;
  seen.reserve(points.size());
  flat.reserve(points.size());
  for (const Point& p : points) {
    if (!p.in_view()) continue;
    seen.push_back({p.x / p.z, p.y / p.z});
    flat.push_back({p.x, p.y});
  }
  const NearestSpacing in_view = nearest_spacing(seen);
  const NearestSpacing on_ground = nearest_spacing(flat);
  return {in_view.median, in_view.median > 0 && in_view.spread < max_spread &&
                              in_view.spread - 1 < (on_ground.spread - 1) / 2};
}

std::string evidence_of(double depth, double step, bool whole) {
  char text[240];
  std::snprintf(text, sizeof text,
                "a camera saw its points from the origin, the nearest are %.4g away and "
                "neighbours %.2g apart%s, which no depth camera measures in metres",
                depth, step, whole ? ", depths are whole numbers" : "");
  return text;
}

}  // namespace

std::optional<Suspicion> suspected_unit(std::span<const float> xyz) {
  if (!may_be_far(xyz)) return std::nullopt;
  const std::vector<Point> points = measured_points(xyz);
  if (points.size() < min_points || share_of(points, &Point::in_view) < most) return std::nullopt;

  const bool whole = share_of(points, [](const Point& p) { return is_whole(p.z); }) > most;
  const double depth = depth_percentile(points, 0.01);
  if (depth < (whole ? nearest_whole : nearest)) return std::nullopt;

  const bool all_whole = whole && share_of(points, [](const Point& p) {
                                    return is_whole(p.x) && is_whole(p.y);
                                  }) > most;
  const Image image = image_of(points, all_whole ? rounded : alike);
  const double step = image.pitch * depth_percentile(points, 0.5);
  if (!image.is_camera || step < least_step) return std::nullopt;
  return Suspicion{Unit::millimetre, evidence_of(depth, step, whole)};
}

void make_metres(std::span<float> xyz, std::optional<Unit> unit, const std::string& what) {
  if (unit) {
    scale_to_metres(xyz, *unit);
    return;
  }
  const std::optional<Suspicion> suspicion = suspected_unit(xyz);
  if (!suspicion) return;
  const std::string name(unit_names.at(static_cast<std::size_t>(suspicion->unit)));
  throw WrongUnit(what + ": seems to be in " + std::string(plural_of(suspicion->unit)) + ": " +
                  suspicion->evidence + "; set --unit " + name +
                  " to scale it, or --unit m if it is in metres");
}

}  // namespace cleave::recording
