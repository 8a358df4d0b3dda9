// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/describe/oriented_box.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

#include "segmentation/math/portable_math.hpp"

namespace cleave::segmentation {
namespace {

constexpr std::size_t steps_in_quarter_turn = 18;
constexpr std::size_t max_tried_normals = 32;
constexpr float min_cos_alike = 0.985F;  // 10 deg
// Flat segments have no volume either way round; this thickness lets the area decide.
constexpr float min_thickness_m = 0.001F;

struct Direction {
  float cosine = 1, sine = 0;
};

// A box that is turned by a quarter is the same box.
constexpr auto directions = [] {
  std::array<Direction, steps_in_quarter_turn> turned;
  for (std::size_t step = 0; step < turned.size(); ++step) {
    const double angle_rad = std::numbers::pi / 2 * static_cast<double>(step) /
                             static_cast<double>(steps_in_quarter_turn);
    turned[step] = {static_cast<float>(portable::cos(angle_rad)),
                    static_cast<float>(portable::sin(angle_rad))};
  }
  return turned;
}();

struct Limits {
  float low = std::numeric_limits<float>::infinity();
  float high = -std::numeric_limits<float>::infinity();

  void include(float value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  [[nodiscard]] float extent() const { return std::max(high - low, min_thickness_m); }
};

Eigen::Matrix3f frame_around(const Eigen::Vector3f& axis) {
  Eigen::Matrix3f frame;
  frame.col(2) = axis;
  frame.col(0) = axis.unitOrthogonal();
  frame.col(1) = axis.cross(frame.col(0));
  return frame;
}

struct Candidate {
  Eigen::Matrix3f axes = Eigen::Matrix3f::Identity();
  float volume = std::numeric_limits<float>::infinity();
};

Candidate tightest_around(const Eigen::Vector3f& axis, std::span<const Surfel> surface) {
  const Eigen::Matrix3f frame = frame_around(axis);
  std::array<Limits, steps_in_quarter_turn> first, second;
  Limits along;
  for (const Surfel& surfel : surface) {
    const Eigen::Vector3f p = frame.transpose() * surfel.position;
    along.include(p.z());
    for (std::size_t step = 0; step < directions.size(); ++step) {
      const auto& [cosine, sine] = directions[step];
      first[step].include(cosine * p.x() + sine * p.y());
      second[step].include(cosine * p.y() - sine * p.x());
    }
  }

  Candidate best;
  for (std::size_t step = 0; step < directions.size(); ++step) {
    const float volume = along.extent() * first[step].extent() * second[step].extent();
    if (volume >= best.volume) continue;
    const auto& [cosine, sine] = directions[step];
    best.volume = volume;
    best.axes.col(0) = frame.col(0) * cosine + frame.col(1) * sine;
    best.axes.col(1) = frame.col(1) * cosine - frame.col(0) * sine;
    best.axes.col(2) = frame.col(2);
  }
  return best;
}

}  // namespace

Eigen::Vector3f dominant_normal(std::span<const Surfel> surface) {
  const std::size_t step = surface.size() / max_tried_normals + 1;
  std::size_t most_alike = 0;
  Eigen::Vector3f dominant = surface.front().normal;
  for (std::size_t tried = 0; tried < surface.size(); tried += step) {
    const Eigen::Vector3f& normal = surface[tried].normal;
    const auto alike = static_cast<std::size_t>(
        std::count_if(surface.begin(), surface.end(),
                      [&](const Surfel& s) { return s.normal.dot(normal) > min_cos_alike; }));
    if (alike <= most_alike) continue;
    most_alike = alike;
    dominant = normal;
  }
  return dominant;
}

Eigen::Matrix3f box_axes(std::span<const Surfel> surface,
                         std::span<const Eigen::Vector3f> candidate_axes) {
  Candidate best;
  for (const Eigen::Vector3f& axis : candidate_axes) {
    const Candidate candidate = tightest_around(axis, surface);
    if (candidate.volume < best.volume) best = candidate;
  }
  return best.axes;
}

OrientedBox make_box(const Eigen::Matrix3f& axes, const Eigen::Vector3f& low,
                     const Eigen::Vector3f& high) {
  const Eigen::Vector3f extent = high - low;
  std::array<int, 3> by_extent = {0, 1, 2};
  std::sort(by_extent.begin(), by_extent.end(), [&](int l, int r) {
    return extent[l] > extent[r] || (extent[l] == extent[r] && l < r);
  });
  Eigen::Matrix3f sorted;
  OrientedBox box;
  for (int i = 0; i < 3; ++i) {
    const int from = by_extent[static_cast<std::size_t>(i)];
    sorted.col(i) = axes.col(from);
    box.extent[i] = extent[from];
  }
  if (sorted.determinant() < 0) sorted.col(2) = -sorted.col(2);
  box.centre = axes * (low + high) / 2;
  box.orientation = Eigen::Quaternionf(sorted).normalized();
  return box;
}

}  // namespace cleave::segmentation
