// SPDX-License-Identifier: BSD-3-Clause
#include "recording/pcd/stream_cloud.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "recording/pcd/error.hpp"
#include "tests/unit/recording/pcd/pcd_files.hpp"

namespace cleave::recording {
namespace {

class StreamClouds : public testing::Test {
 protected:
  [[nodiscard]] StreamCloud read(const std::string& content) const {
    return read_stream_cloud(folder_.write("cloud.pcd", content), 1000);
  }
  TestFolder folder_;
};

TEST_F(StreamClouds, ReadsAscii) {
  const StreamCloud cloud = read(to_file({}));
  EXPECT_EQ(cloud.width, 2U);
  EXPECT_EQ(cloud.height, 1U);
  EXPECT_EQ(cloud.xyz, (std::vector<float>{1, 2, 3, 4, 5, 6}));
}

TEST_F(StreamClouds, PassesBinaryValuesOnBitForBit) {
  const std::vector<float> xyz = {0.1F, -0.0F, 1e-42F, 3.0F, std::nextafter(1.0F, 2.0F), 1e30F};
  const StreamCloud cloud = read(binary_file(xyz, 1, 2));
  EXPECT_EQ(cloud.height, 2U);
  EXPECT_EQ(std::memcmp(cloud.xyz.data(), xyz.data(), xyz.size() * sizeof(float)), 0);
}

TEST_F(StreamClouds, ReadsCompressedDataFieldByField) {
  PcdText pcd;
  pcd.encoding = "binary_compressed";
  pcd.data = compressed_body(bytes_of<float>({1, 4, 2, 5, 3, 6}));
  EXPECT_EQ(read(to_file(pcd)).xyz, (std::vector<float>{1, 2, 3, 4, 5, 6}));
}

TEST_F(StreamClouds, FindsTheCoordinatesAmongOtherFields) {
  PcdText pcd;
  pcd.fields = "label z y x";
  pcd.size = "4 4 4 4";
  pcd.type = "U F F F";
  pcd.count = "1 1 1 1";
  pcd.data = "9 3 2 1\n9 6 5 4\n";
  EXPECT_EQ(read(to_file(pcd)).xyz, (std::vector<float>{1, 2, 3, 4, 5, 6}));
}

TEST_F(StreamClouds, RoundsDoublesToFloat) {
  PcdText pcd;
  pcd.size = "8 8 8";
  pcd.encoding = "binary";
  pcd.data = bytes_of<double>({0.1, 0.2, 0.3, 1, 2, 1e300});
  const StreamCloud cloud = read(to_file(pcd));
  EXPECT_EQ(cloud.xyz[0], 0.1F);
  EXPECT_EQ(cloud.xyz[2], 0.3F);
  EXPECT_TRUE(std::isnan(cloud.xyz[3])) << "beyond float's range is no measurement";
}

TEST_F(StreamClouds, MakesAPointWithANonFiniteCoordinateNoMeasurement) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const StreamCloud cloud = read(binary_file({nan, 2, 3, 1, infinity, 3, 1, 2, 3}, 3, 1));
  for (std::size_t i = 0; i < 6; ++i) EXPECT_TRUE(std::isnan(cloud.xyz[i])) << i;
  EXPECT_EQ(cloud.xyz[6], 1);
  EXPECT_EQ(cloud.xyz[8], 3);
}

TEST_F(StreamClouds, RefusesMorePointsThanACallerTakes) {
  PcdText pcd;
  pcd.width = pcd.points = "1001";
  try {
    (void)read(to_file(pcd));
    FAIL() << "it was taken";
  } catch (const PcdError& error) {
    EXPECT_EQ(error.cause(), PcdCause::too_many_points);
    EXPECT_NE(std::string(error.what()).find("1001 points, 1001 x 1, where at most 1000 fit"),
              std::string::npos)
        << error.what();
  }
}

TEST_F(StreamClouds, GivesUnorganisedCloudsNoIntrinsics) {
  const StreamCloud cloud = read(to_file({}));
  EXPECT_EQ(cloud.intrinsics.fx, 0);
  EXPECT_EQ(cloud.intrinsics.cy, 0);
}

}  // namespace
}  // namespace cleave::recording
