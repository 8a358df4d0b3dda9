// SPDX-License-Identifier: BSD-3-Clause
// Coordinates of any type as floats, near zero and far from it; where the sensor was.
#include <gtest/gtest.h>

#include <cmath>

#include "recording/pcd/cloud.hpp"
#include "tests/unit/recording/pcd/pcd_files.hpp"

namespace cleave::recording {
namespace {

using Origin = std::array<double, 3>;

PcdCloud read(const PcdText& pcd) {
  const TestFolder folder;
  return PcdCloud::read(folder.write("a.pcd", to_file(pcd)));
}

// A binary file of one type for x, y and z.
template <class Number>
PcdCloud cloud_of(const std::vector<Number>& xyz, const char* type) {
  PcdText pcd;
  const std::string size = std::to_string(sizeof(Number));
  pcd.size = size + " " + size + " " + size;
  pcd.type = std::string(type) + " " + type + " " + type;
  pcd.width = pcd.points = std::to_string(xyz.size() / 3);
  pcd.encoding = "binary";
  pcd.data = bytes_of(xyz);
  return read(pcd);
}

// A grid of 20 x 20 points, `spacing` apart, at z = 5 * spacing.
std::vector<double> grid(double x, double y, double z, double spacing = 0.05137) {
  std::vector<double> xyz;
  for (int i = 0; i < 400; ++i) {
    xyz.insert(xyz.end(), {x + spacing * (i % 20), y + spacing * (i / 20), z + 5 * spacing});
  }
  return xyz;
}

template <class Number>
std::vector<float> rounded(const std::vector<Number>& xyz) {
  std::vector<float> result;
  for (const Number value : xyz) result.push_back(static_cast<float>(value));
  return result;
}

std::vector<float> xyz_of(const PcdCloud& cloud) {
  return {cloud.xyz().begin(), cloud.xyz().end()};
}

TEST(PcdCoordinates, MayBeOfAnyType) {
  EXPECT_EQ(xyz_of(cloud_of<std::int8_t>({-1, 2, 127}, "I")), (std::vector<float>{-1, 2, 127}));
  EXPECT_EQ(xyz_of(cloud_of<std::uint8_t>({255, 2, 3}, "U")), (std::vector<float>{255, 2, 3}));
  EXPECT_EQ(xyz_of(cloud_of<std::int16_t>({-500, 2, 3}, "I")), (std::vector<float>{-500, 2, 3}));
  EXPECT_EQ(xyz_of(cloud_of<std::uint16_t>({65535, 2, 3}, "U")), (std::vector<float>{65535, 2, 3}));
  EXPECT_EQ(xyz_of(cloud_of<std::int32_t>({-70000, 2, 3}, "I")),
            (std::vector<float>{-70000, 2, 3}));
  EXPECT_EQ(xyz_of(cloud_of<std::uint32_t>({70000, 2, 3}, "U")), (std::vector<float>{70000, 2, 3}));
  EXPECT_EQ(xyz_of(cloud_of<std::int64_t>({-7, 2, 3}, "I")), (std::vector<float>{-7, 2, 3}));
  EXPECT_EQ(xyz_of(cloud_of<std::uint64_t>({7, 2, 3}, "U")), (std::vector<float>{7, 2, 3}));
}

TEST(PcdCoordinates, OfFloatsAreTheFilesOwnBitsHoweverFarFromZero) {
  const std::vector<float> xyz = rounded(grid(1e6, -2e6, 100));
  const PcdCloud cloud = cloud_of(xyz, "F");
  EXPECT_EQ(cloud.origin(), Origin{});
  EXPECT_EQ(xyz_of(cloud), xyz);
}

TEST(PcdCoordinates, OfDoublesNearZeroAreRoundedAsEver) {
  const std::vector<double> xyz = grid(-0.5, -0.5, 2);
  const PcdCloud cloud = cloud_of(xyz, "F");
  EXPECT_EQ(cloud.origin(), Origin{});
  EXPECT_EQ(xyz_of(cloud), rounded(xyz));
}

TEST(PcdCoordinates, OfDoublesThatFloatsHoldNeedNoOrigin) {
  EXPECT_EQ(cloud_of(grid(1e6, 1e6, 1e6, 0.25), "F").origin(), Origin{});
}

TEST(PcdCoordinates, OfDoublesFarFromZeroLoseNothing) {
  for (const double offset : {100.0, -5000.0, 1e6, 5e8}) {
    const std::vector<double> xyz = grid(offset, 0.3 * offset, 0);
    const PcdCloud cloud = cloud_of(xyz, "F");
    ASSERT_NE(cloud.origin(), Origin{}) << offset;
    for (std::size_t i = 0; i < xyz.size(); ++i) {
      const double back = cloud.origin()[i % 3] + static_cast<double>(cloud.xyz()[i]);
      ASSERT_NEAR(back, xyz[i], std::abs(offset) > 1e8 ? 2e-5 : 1e-7) << offset;
    }
  }
}

TEST(PcdCoordinates, AreTheSameForTheSameSceneAtAnyWholeOffset) {
  const PcdCloud a = cloud_of(grid(1 << 20, 0, 0, 1.0 / 1024 + 1.0 / (1 << 28)), "F");
  const PcdCloud b = cloud_of(grid((1 << 20) + 512, 0, 0, 1.0 / 1024 + 1.0 / (1 << 28)), "F");
  EXPECT_EQ(xyz_of(a), xyz_of(b));
  EXPECT_EQ(b.origin()[0] - a.origin()[0], 512);
}

TEST(PcdCoordinates, OfLargeIntegersLoseNothing) {
  std::vector<std::int32_t> xyz;
  for (std::int32_t i = 0; i < 100; ++i) {
    xyz.insert(xyz.end(), {400000001 + 7 * i, 500000003 + 3 * i, i});
  }
  const PcdCloud cloud = cloud_of(xyz, "I");
  for (std::size_t i = 0; i < xyz.size(); ++i) {
    ASSERT_EQ(cloud.origin()[i % 3] + static_cast<double>(cloud.xyz()[i]), xyz[i]);
  }
}

TEST(PcdCoordinates, AreNotPulledAsideByPointsWithoutMeasurement) {
  std::vector<double> xyz = grid(1e6, 1e6, 0);
  for (std::size_t i = 0; i < 900; i += 3) {
    for (std::size_t axis = 0; axis < 3; ++axis) xyz[i + axis] = i % 2 == 0 ? 0 : NAN;
  }
  const PcdCloud cloud = cloud_of(xyz, "F");
  EXPECT_NEAR(cloud.origin()[0], 1e6, 2);
  EXPECT_TRUE(std::isnan(cloud.xyz()[0])) << "0 0 0 could not be told from a point any more";
  EXPECT_TRUE(std::isnan(cloud.xyz()[3]));
  EXPECT_FALSE(std::isnan(cloud.xyz()[900]));
  const std::vector<double> as_written(reinterpret_cast<const double*>(cloud.data().data()),
                                       reinterpret_cast<const double*>(cloud.data().data()) + 3);
  EXPECT_EQ(as_written, (std::vector<double>{0, 0, 0})) << "the file's own values stay";
}

TEST(PcdCoordinates, Of000StayThatNearZero) {
  EXPECT_EQ(xyz_of(cloud_of<float>({0, 0, 0, 1, 2, 3}, "F")),
            (std::vector<float>{0, 0, 0, 1, 2, 3}));
}

PcdCloud seen_from(const std::string& viewpoint) {
  PcdText pcd;
  pcd.viewpoint = viewpoint;
  return read(pcd);
}

TEST(PcdViewpoint, IsWhereTheSensorWas) {
  const auto pose = seen_from("1000000.25 -2 0.5 0 0 2 0").sensor_pose();
  ASSERT_TRUE(pose);
  EXPECT_EQ(pose->position, (Origin{1000000.25, -2, 0.5}));
  EXPECT_EQ(pose->orientation, (std::array<double, 4>{0, 0, 1, 0})) << "of length 1";
}

TEST(PcdViewpoint, ThatIsTheDefaultOrNoRotationSaysNothing) {
  EXPECT_FALSE(seen_from("0 0 0 1 0 0 0").sensor_pose());
  EXPECT_FALSE(seen_from("0 0 0 0 0 0 0").sensor_pose());
  EXPECT_FALSE(seen_from("1 2 3 0 0 0 0").sensor_pose());
  EXPECT_FALSE(PcdCloud::of_points(std::vector<float>{1, 2, 3}, 1, 1).sensor_pose());
  EXPECT_TRUE(seen_from("0 0 1 1 0 0 0").sensor_pose());
}

}  // namespace
}  // namespace cleave::recording
