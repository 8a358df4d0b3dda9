// SPDX-License-Identifier: BSD-3-Clause
#include "recording/ros/point_cloud.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <type_traits>

#include "recording/cdr/byte_order.hpp"
#include "recording/cloud/measured.hpp"
#include "recording/ros/unusable.hpp"

namespace cleave::recording::ros {
namespace {

// Of PointField.
enum Datatype : std::uint8_t {
  int8 = 1,
  uint8 = 2,
  int16 = 3,
  uint16 = 4,
  int32 = 5,
  uint32 = 6,
  float32 = 7,
  float64 = 8
};

std::size_t size_of(std::uint8_t datatype) {
  constexpr std::array<std::size_t, 9> sizes = {0, 1, 1, 2, 2, 4, 4, 4, 8};
  return datatype < sizes.size() ? sizes.at(datatype) : 0;
}

std::string names_of(const PointCloud2& cloud) {
  std::string names;
  for (const PointField& field : cloud.fields) names += (names.empty() ? "" : ", ") + field.name;
  return names.empty() ? "none" : names;
}

// Throws Unusable.
const PointField& field_of(const PointCloud2& cloud, const char* name) {
  const auto found = std::ranges::find(cloud.fields, name, &PointField::name);
  if (found == cloud.fields.end()) {
    throw Unusable("no x, y, z",
                   std::string("has no field ") + name + "; its fields are " + names_of(cloud));
  }
  const std::size_t size = size_of(found->datatype);
  if (size == 0) {
    throw Unusable("no x, y, z", std::string("its field ") + name + " has the datatype " +
                                     std::to_string(found->datatype) + ", which ROS does not know");
  }
  if (std::uint64_t{found->offset} + size > cloud.point_step) {
    throw Unusable("no x, y, z", std::string("its field ") + name + " ends behind its points of " +
                                     std::to_string(cloud.point_step) + " bytes");
  }
  return *found;
}

// Throws Unusable.
void check_size(const PointCloud2& cloud) {
  if (cloud.width == 0 || cloud.height == 0) throw Unusable("no points", "holds no points");
  const std::uint64_t row = std::uint64_t{cloud.width} * cloud.point_step;
  if (cloud.height > 1 && cloud.row_step < row) {
    throw Unusable("damaged", "its rows of " + std::to_string(cloud.width) + " points of " +
                                  std::to_string(cloud.point_step) +
                                  " bytes overlap: row_step is " + std::to_string(cloud.row_step));
  }
  const std::uint64_t needed = std::uint64_t{cloud.height - 1} * cloud.row_step + row;
  if (needed > cloud.data.size()) {
    throw Unusable("damaged", "holds " + std::to_string(cloud.data.size()) + " bytes, " +
                                  std::to_string(cloud.width) + " x " +
                                  std::to_string(cloud.height) + " points need " +
                                  std::to_string(needed));
  }
}

template <class Number>
float coordinate(const std::byte* from, bool swap) {
  Number value;
  std::memcpy(&value, from, sizeof value);
  if (swap) value = byte_swapped(value);
  if constexpr (std::is_same_v<Number, double>) {
    if (!(std::fabs(value) <= double{std::numeric_limits<float>::max()})) return no_measurement;
  }
  return static_cast<float>(value);
}

template <class Number>
void copy_axis(const PointCloud2& cloud, std::size_t offset, float* to) {
  for (std::uint32_t v = 0; v < cloud.height; ++v) {
    const std::byte* from = cloud.data.data() + std::size_t{v} * cloud.row_step + offset;
    for (std::uint32_t u = 0; u < cloud.width; ++u, from += cloud.point_step, to += 3) {
      *to = coordinate<Number>(from, cloud.is_bigendian);
    }
  }
}

void copy_axis(const PointCloud2& cloud, const PointField& field, float* to) {
  switch (static_cast<Datatype>(field.datatype)) {
    case int8:
      return copy_axis<std::int8_t>(cloud, field.offset, to);
    case uint8:
      return copy_axis<std::uint8_t>(cloud, field.offset, to);
    case int16:
      return copy_axis<std::int16_t>(cloud, field.offset, to);
    case uint16:
      return copy_axis<std::uint16_t>(cloud, field.offset, to);
    case int32:
      return copy_axis<std::int32_t>(cloud, field.offset, to);
    case uint32:
      return copy_axis<std::uint32_t>(cloud, field.offset, to);
    case float32:
      return copy_axis<float>(cloud, field.offset, to);
    case float64:
      return copy_axis<double>(cloud, field.offset, to);
  }
}

}  // namespace

void check_fields(const PointCloud2& cloud) {
  for (const char* const name : {"x", "y", "z"}) (void)field_of(cloud, name);
}

std::vector<float> points_of(const PointCloud2& cloud) {
  check_fields(cloud);
  check_size(cloud);
  std::vector<float> xyz(3 * std::size_t{cloud.width} * cloud.height);
  std::size_t axis = 0;
  for (const char* const name : {"x", "y", "z"}) {
    copy_axis(cloud, field_of(cloud, name), &xyz[axis++]);
  }
  for (std::size_t i = 0; i < xyz.size(); i += 3) {
    if (is_measured(&xyz[i])) continue;
    std::fill_n(&xyz[i], 3, no_measurement);
  }
  return xyz;
}

}  // namespace cleave::recording::ros
