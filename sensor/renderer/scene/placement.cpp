// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/renderer/scene/placement.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "sensor/renderer/scene/random_object.hpp"

namespace cleave::render {
namespace {

constexpr double highest_support_m = 0.22;
constexpr double highest_stack_m = 0.36;
constexpr double overhang_outside_area_m = 0.08;
constexpr std::uint32_t attempts_per_size = 200;
constexpr double shrink = 0.95;

// An object with what collisions need of it.
struct Placed {
  Object object;
  std::vector<Polygon> polygons;
  double bottom_m, top_m;

  explicit Placed(const Object& o)
      : object(o),
        polygons(footprint(o)),
        bottom_m(o.base_m.z()),
        top_m(o.base_m.z() + height_m(o.shape)) {}

  bool on_table() const { return bottom_m == 0; }
};

bool footprints_overlap(const Placed& a, const Placed& b) {
  return std::ranges::any_of(a.polygons, [&b](const Polygon& mine) {
    return std::ranges::any_of(b.polygons,
                               [&mine](const Polygon& theirs) { return overlap(mine, theirs); });
  });
}

// As prisms over their footprints: never less than the objects themselves.
bool collide(const Placed& a, const Placed& b) {
  return a.bottom_m < b.top_m && b.bottom_m < a.top_m && footprints_overlap(a, b);
}

bool stands_within(const Placed& upper, const Placed& support) {
  return std::ranges::all_of(upper.polygons, [&support](const Polygon& polygon) {
    return std::ranges::all_of(polygon, [&support](const Eigen::Vector2d& corner) {
      return contains(support.polygons.front(), corner);
    });
  });
}

class Table {
 public:
  Table(const PlacementArea& area, const PlacementChances& chances, Random& random)
      : area_(area), chances_(chances), random_(random) {}

  bool try_to_add(double scale) {
    const Object object = random_object(random_, scale);
    const std::optional<Placed> candidate = propose(object);
    if (!candidate || !near_area(*candidate)) return false;
    if (std::ranges::any_of(placed_, [&](const Placed& p) { return collide(*candidate, p); })) {
      return false;
    }
    placed_.push_back(*candidate);
    return true;
  }

  std::size_t size() const { return placed_.size(); }

  std::vector<Object> objects() const {
    std::vector<Object> objects;
    for (const Placed& placed : placed_) objects.push_back(placed.object);
    return objects;
  }

 private:
  std::optional<Placed> propose(const Object& object) {
    const double kind = random_.uniform(0, 1);
    if (placed_.empty() || kind >= chances_.stacked + chances_.touching)
      return standing_free(object);
    const Placed& other = placed_[random_.below(static_cast<std::uint32_t>(placed_.size()))];
    return kind < chances_.stacked ? on_top_of(other, object) : touching(other, object);
  }

  Placed standing_free(Object object) {
    const Eigen::Vector2d offset{random_.uniform(-area_.half_m.x(), area_.half_m.x()),
                                 random_.uniform(-area_.half_m.y(), area_.half_m.y())};
    object.base_m.head<2>() = area_.centre_m + offset;
    return Placed(object);
  }

  // With its centre above the middle of the support; overhanging now and then, but only on
  // something that stands on the table itself, or the tower would fall.
  std::optional<Placed> on_top_of(const Placed& support, Object object) {
    if (!has_flat_top(support.object.shape) || support.top_m > highest_support_m) return {};
    if (std::holds_alternative<Sphere>(object.shape)) return {};
    const Eigen::Vector2d offset = random_offset_on(support.object);
    object.base_m.head<2>() = support.object.base_m.head<2>() + offset;
    object.base_m.z() = support.top_m;
    if (random_.chance(0.5)) object.yaw_rad = support.object.yaw_rad + random_.uniform(-0.3, 0.3);
    const Placed upper(object);
    const bool may_overhang = random_.chance(0.25) && support.on_table();
    if (upper.top_m > highest_stack_m) return {};
    if (!may_overhang && !stands_within(upper, support)) return {};
    return upper;
  }

  Eigen::Vector2d random_offset_on(const Object& support) {
    Eigen::Vector2d half_m;
    if (const auto* box = std::get_if<Box>(&support.shape)) {
      half_m = box->half_m.head<2>();
    } else {
      half_m.setConstant(std::get<Cylinder>(support.shape).radius_m);
    }
    const Eigen::Vector2d share{random_.uniform(-0.5, 0.5), random_.uniform(-0.5, 0.5)};
    return Eigen::Rotation2Dd(support.yaw_rad) * share.cwiseProduct(half_m);
  }

  // Slides along a line towards `other` until 0.2 to 2 mm are left, found by bisection.
  std::optional<Placed> touching(const Placed& other, Object object) {
    if (!other.on_table()) return {};
    double angle_rad = random_.uniform(0, 2 * std::numbers::pi);
    if (std::holds_alternative<Box>(other.object.shape) && random_.chance(0.5)) {
      angle_rad = other.object.yaw_rad + random_.below(4) * std::numbers::pi / 2;
      if (random_.chance(0.7)) object.yaw_rad = other.object.yaw_rad;
    }
    const Eigen::Vector2d along(std::cos(angle_rad), std::sin(angle_rad));
    const Eigen::Vector2d across(-along.y(), along.x());
    const Eigen::Vector2d start =
        other.object.base_m.head<2>() + random_.uniform(-0.05, 0.05) * across;
    const auto at = [&](double distance_m) {
      object.base_m.head<2>() = start + distance_m * along;
      return Placed(object);
    };
    double within_m = 0;
    double apart_m = 0.5;
    if (!collide(at(within_m), other) || collide(at(apart_m), other)) return {};
    while (apart_m - within_m > 1e-6) {
      const double middle_m = (within_m + apart_m) / 2;
      (collide(at(middle_m), other) ? within_m : apart_m) = middle_m;
    }
    return at(apart_m + random_.uniform(0.0002, 0.002));
  }

  bool near_area(const Placed& placed) const {
    const Eigen::Array2d offset = (placed.object.base_m.head<2>() - area_.centre_m).array().abs();
    return (offset <= area_.half_m.array() + overhang_outside_area_m).all();
  }

  PlacementArea area_;
  PlacementChances chances_;
  Random& random_;
  std::vector<Placed> placed_;
};

}  // namespace

std::vector<Object> place_objects(std::uint32_t count, double scale, const PlacementArea& area,
                                  const PlacementChances& chances, Random& random) {
  Table table(area, chances, random);
  std::uint32_t failures = 0;
  while (table.size() < count) {
    if (table.try_to_add(scale)) {
      failures = 0;
    } else if (++failures == attempts_per_size) {
      failures = 0;
      scale *= shrink;
    }
  }
  return table.objects();
}

}  // namespace cleave::render
