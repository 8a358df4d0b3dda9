// SPDX-License-Identifier: BSD-3-Clause
#include "recording/pcd/coordinates.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "recording/cloud/measured.hpp"
#include "recording/percentile.hpp"

namespace cleave::recording {
namespace {

constexpr double farthest_extents = 8;

// Calls `use` with each value of a field in turn.
template <class Number, class Use>
void each_of(std::span<const std::uint8_t> data, std::size_t offset, std::size_t step, Use use) {
  for (std::size_t at = offset; at < data.size(); at += step) {
    Number value;
    std::memcpy(&value, &data[at], sizeof value);
    use(value);
  }
}

template <class Use>
void each_value(const PcdHeader& header, std::string_view name, std::span<const std::uint8_t> data,
                Use use) {
  const std::size_t index = header.find(name).value();
  const PcdField& field = header.fields[index];
  const std::size_t offset = header.offset_of(index);
  const std::size_t step = header.point_bytes();
  const bool is_signed = field.type == 'I';
  if (field.type == 'F') {
    return field.size == 4 ? each_of<float>(data, offset, step, use)
                           : each_of<double>(data, offset, step, use);
  }
  switch (field.size) {
    case 1:
      return is_signed ? each_of<std::int8_t>(data, offset, step, use)
                       : each_of<std::uint8_t>(data, offset, step, use);
    case 2:
      return is_signed ? each_of<std::int16_t>(data, offset, step, use)
                       : each_of<std::uint16_t>(data, offset, step, use);
    case 4:
      return is_signed ? each_of<std::int32_t>(data, offset, step, use)
                       : each_of<std::uint32_t>(data, offset, step, use);
    default:
      return is_signed ? each_of<std::int64_t>(data, offset, step, use)
                       : each_of<std::uint64_t>(data, offset, step, use);
  }
}

constexpr std::array<const char*, 3> axes = {"x", "y", "z"};

struct Rounded {
  std::vector<float> xyz;
  bool is_exact = true;  // not a number is, too
};

Rounded rounded_coordinates(const PcdHeader& header, std::span<const std::uint8_t> data) {
  Rounded result;
  result.xyz.resize(3 * header.points());
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    float* to = result.xyz.data() + axis;
    each_value(header, axes[axis], data, [&](auto value) {
      *to = static_cast<float>(value);
      if constexpr (sizeof value > 2 && !std::is_same_v<decltype(value), float>) {
        const auto exact = static_cast<double>(value);
        if (static_cast<double>(*to) != exact && !std::isnan(exact)) result.is_exact = false;
      }
      to += 3;
    });
  }
  return result;
}

std::vector<double> exact_coordinates(const PcdHeader& header, std::span<const std::uint8_t> data) {
  std::vector<double> xyz(3 * header.points());
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    double* to = xyz.data() + axis;
    each_value(header, axes[axis], data, [&](auto value) {
      *to = static_cast<double>(value);
      to += 3;
    });
  }
  return xyz;
}

// 0 0 0, or where the cloud is, in units of its distance / 2^20, so that 21 bits hold it.
std::array<double, 3> find_origin(const std::vector<double>& xyz) {
  std::array<double, 3> middle{};
  double distance = 0;
  double extent = 0;
  for (std::size_t axis = 0; axis < middle.size(); ++axis) {
    std::vector<double> values;
    for (std::size_t i = 0; i < xyz.size(); i += 3) {
      if (is_measured(&xyz[i])) values.push_back(xyz[i + axis]);
    }
    if (values.empty()) return {};
    middle[axis] = percentile(values, 0.5);
    distance = std::max(distance, std::abs(middle[axis]));
    extent = std::max(extent, percentile(values, 0.95) - percentile(values, 0.05));
  }
  if (extent == 0 || distance <= farthest_extents * extent) return {};
  const double unit = std::ldexp(1.0, std::ilogb(distance) - 20);
  for (double& coordinate : middle) coordinate = std::round(coordinate / unit) * unit;
  return middle;
}

}  // namespace

Coordinates coordinates_of(const PcdHeader& header, std::span<const std::uint8_t> data) {
  Rounded rounded = rounded_coordinates(header, data);
  if (rounded.is_exact) return {std::move(rounded.xyz), {}};
  const std::vector<double> exact = exact_coordinates(header, data);
  const std::array<double, 3> origin = find_origin(exact);
  if (origin == std::array<double, 3>{}) return {std::move(rounded.xyz), {}};
  for (std::size_t i = 0; i < exact.size(); i += 3) {
    const bool is_zero = exact[i] == 0 && exact[i + 1] == 0 && exact[i + 2] == 0;
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
      rounded.xyz[i + axis] = is_zero ? std::numeric_limits<float>::quiet_NaN()
                                      : static_cast<float>(exact[i + axis] - origin[axis]);
    }
  }
  return {std::move(rounded.xyz), origin};
}

}  // namespace cleave::recording
