// SPDX-License-Identifier: BSD-3-Clause
#include "recording/ros/point_cloud.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <tuple>

#include "recording/ros/unusable.hpp"
#include "tests/unit/recording/ros/ros_bytes.hpp"

namespace cleave::recording::ros {
namespace {

std::vector<float> points(const CloudSpec& cloud, Format format = Format::cdr_le) {
  const Bytes message = bytes_of_cloud(cloud, format);
  return points_of(
      read_point_cloud2(reader_of(message, format == Format::ros1 ? Wire::ros1 : Wire::cdr)));
}

std::string cause_of(const CloudSpec& cloud) {
  try {
    (void)points(cloud);
  } catch (const Unusable& error) {
    return error.cause();
  }
  return "none";
}

constexpr std::size_t sizes[] = {0, 1, 1, 2, 2, 4, 4, 4, 8};

Bytes bytes_of_value(int value, std::uint8_t datatype, bool big_endian) {
  switch (datatype) {
    case 1:
      return bytes_of_number(static_cast<std::int8_t>(value), big_endian);
    case 2:
      return bytes_of_number(static_cast<std::uint8_t>(value), big_endian);
    case 3:
      return bytes_of_number(static_cast<std::int16_t>(value), big_endian);
    case 4:
      return bytes_of_number(static_cast<std::uint16_t>(value), big_endian);
    case 5:
      return bytes_of_number(std::int32_t{value}, big_endian);
    case 6:
      return bytes_of_number(static_cast<std::uint32_t>(value), big_endian);
    case 7:
      return bytes_of_number(static_cast<float>(value), big_endian);
    default:
      return bytes_of_number(static_cast<double>(value), big_endian);
  }
}

// Datatype, byte order of the points, rows, format of the message.
using Layout = std::tuple<int, bool, std::uint32_t, Format>;
class EveryLayout : public testing::TestWithParam<Layout> {};

// z first, a gap, y, another field, x; bytes behind every point and every row, none of them 0.
TEST_P(EveryLayout, GivesThePointsBack) {
  const auto [type, big_endian, height, format] = GetParam();
  const auto datatype = static_cast<std::uint8_t>(type);
  const auto size = static_cast<std::uint32_t>(sizes[datatype]);
  CloudSpec cloud;
  cloud.width = 3;
  cloud.height = height;
  cloud.big_endian = big_endian;
  cloud.fields = {{"z", 1, datatype},
                  {"intensity", size + 4, 4},
                  {"y", size + 6, datatype, 0},
                  {"x", 2 * size + 7, datatype, 2},
                  {"rgb", 3 * size + 7, 7}};
  cloud.point_step = 4 * size + 13;
  cloud.row_step = 3 * cloud.point_step + 5;
  cloud.data.assign(std::size_t{cloud.row_step} * height - 5, std::byte{0xA5});
  std::vector<float> expected;
  for (std::uint32_t i = 0; i < 3 * height; ++i) {
    const std::size_t at = (i / 3) * cloud.row_step + (i % 3) * cloud.point_step;
    for (const auto& [axis, offset] :
         {std::pair{0, 2 * size + 7}, std::pair{1, size + 6}, std::pair{2, 1U}}) {
      const int value = static_cast<int>(10 * i) + axis;
      const Bytes bytes = bytes_of_value(value, datatype, big_endian);
      std::copy(bytes.begin(), bytes.end(),
                cloud.data.begin() + static_cast<std::ptrdiff_t>(at + offset));
      expected.push_back(static_cast<float>(value));
    }
  }
  EXPECT_EQ(points(cloud, format), expected);
}

INSTANTIATE_TEST_SUITE_P(
    PointCloud2, EveryLayout,
    testing::Combine(testing::Range(1, 9), testing::Bool(), testing::Values(1U, 4U),
                     testing::Values(Format::cdr_le, Format::cdr_be, Format::ros1)));

TEST(PointCloud2, KeepsNegativeAndFractionalCoordinates) {
  CloudSpec cloud = cloud_of({-1.25F, 0.1F, 3e-5F}, 1, 1);
  EXPECT_EQ(points(cloud), (std::vector<float>{-1.25F, 0.1F, 3e-5F}));
  cloud.fields = {{"x", 0, 3}, {"y", 2, 3}, {"z", 4, 1}};
  cloud.data = Bytes(12, std::byte{0xFF});
  EXPECT_EQ(points(cloud), (std::vector<float>{-1, -1, -1}));
}

TEST(PointCloud2, TakesEveryPointThatIsNotFiniteOr000AsNoMeasurement) {
  constexpr float inf = std::numeric_limits<float>::infinity();
  const std::vector<float> xyz = points(cloud_of({1, 2, inf, NAN, 1, 2, 0, 0, 0}, 3, 1));
  for (std::size_t i = 0; i < xyz.size(); ++i) EXPECT_TRUE(std::isnan(xyz[i])) << i;
}

TEST(PointCloud2, TakesADoubleBeyondAFloatAsNoMeasurement) {
  CloudSpec cloud;
  cloud.width = 1;
  cloud.fields = {{"x", 0, 8}, {"y", 0, 8}, {"z", 0, 8}};
  cloud.data = bytes_of_number(1e300, false);
  cloud.data.resize(12);
  EXPECT_TRUE(std::isnan(points(cloud)[0]));
}

TEST(PointCloud2, IgnoresTheRowStepOfASingleRow) {
  CloudSpec cloud;
  cloud.row_step = 0;
  EXPECT_EQ(points(cloud).size(), 12U);
}

TEST(PointCloud2, SaysWhatIsMissing) {
  CloudSpec cloud;
  cloud.fields = {{"x", 0, 7}, {"y", 4, 7}, {"range", 8, 7}};
  try {
    (void)points(cloud);
    FAIL();
  } catch (const Unusable& error) {
    EXPECT_STREQ(error.what(), "has no field z; its fields are x, y, range");
  }
  cloud.fields = {{"x", 0, 7}, {"y", 4, 7}, {"z", 9, 7}};
  EXPECT_EQ(cause_of(cloud), "no x, y, z") << "z ends behind the point";
  cloud.fields = {{"x", 0, 7}, {"y", 4, 7}, {"z", 8, 9}};
  EXPECT_EQ(cause_of(cloud), "no x, y, z") << "no such datatype";
  cloud.fields = {{"x", 0xFFFFFFFF, 7}, {"y", 4, 7}, {"z", 8, 7}};
  EXPECT_EQ(cause_of(cloud), "no x, y, z") << "an offset that wraps around";
}

TEST(PointCloud2, RefusesSizesThatItsDataDoNotHold) {
  CloudSpec cloud;
  cloud.width = 5;
  EXPECT_EQ(cause_of(cloud), "damaged");
  cloud.width = 0;
  EXPECT_EQ(cause_of(cloud), "no points");
  cloud.width = cloud.height = 0xFFFFFFFF;
  cloud.row_step = 0xFFFFFFFF;
  EXPECT_EQ(cause_of(cloud), "damaged");
  cloud = {};
  cloud.width = 2;
  cloud.height = 2;
  cloud.row_step = 12;
  EXPECT_EQ(cause_of(cloud), "damaged") << "rows overlap";
}

}  // namespace
}  // namespace cleave::recording::ros
