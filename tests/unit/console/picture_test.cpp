// SPDX-License-Identifier: BSD-3-Clause
#include "console/picture/picture.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <limits>

#include "console/picture/png_file.hpp"
#include "tests/support/temporary_folder.hpp"

namespace cleave {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr Rgb black{};

int distance(Rgb a, Rgb b) {
  return std::abs(a.red - b.red) + std::abs(a.green - b.green) + std::abs(a.blue - b.blue);
}

bool is_grey(Rgb c) {
  return c.red == c.green && c.green == c.blue;
}

// A wall of 4 x 2 points at 1 and 2 m with one missing measurement, and its labels.
const std::vector<float> wall = {0, 0, 1, 1, 0, 1, 2, 0, 2, nan, nan, nan,
                                 0, 1, 1, 1, 1, 1, 2, 1, 2, 3,   1,   2};
const std::vector<std::uint16_t> wall_labels = {1, 1, 2, 0, 1, 1, 2, 0};
const PointsView wall_view{.xyz = wall.data(), .stride = 3, .width = 4, .height = 2};

TEST(LabelColour, TellsApartLabelsThatFollowEachOther) {
  for (std::uint16_t a = 1; a <= 200; ++a) {
    for (std::uint16_t b = a + 1; b <= a + 7; ++b) {
      EXPECT_GT(distance(label_colour(a), label_colour(b)), 60) << a << ' ' << b;
    }
  }
}

TEST(LabelColour, IsNeverGreyForThatIsNoSegment) {
  for (std::uint16_t label = 1; label < 1000; ++label) EXPECT_FALSE(is_grey(label_colour(label)));
}

TEST(DepthPicture, IsBrightNearDarkFarAndBlackWithoutMeasurement) {
  const Picture picture = depth_picture(depth_image(wall_view, wall_labels));
  ASSERT_EQ(picture.width, 4U);
  ASSERT_EQ(picture.height, 2U);
  EXPECT_TRUE(is_grey(picture.at(0, 0)));
  EXPECT_GT(picture.at(0, 0).red, picture.at(2, 0).red);
  EXPECT_GT(picture.at(2, 0).red, 0);
  EXPECT_EQ(picture.at(3, 0), black);
}

TEST(SegmentPicture, TintsSegmentsLeavesTheRestGreyAndDarkensBorders) {
  const Picture picture = segment_picture(depth_image(wall_view, wall_labels));
  EXPECT_FALSE(is_grey(picture.at(0, 0)));
  EXPECT_EQ(picture.at(3, 0), black);
  EXPECT_TRUE(is_grey(picture.at(3, 1)));
  EXPECT_GT(picture.at(3, 1).red, 0);
  EXPECT_LT(picture.at(1, 0).red + picture.at(1, 0).green + picture.at(1, 0).blue,
            picture.at(0, 0).red + picture.at(0, 0).green + picture.at(0, 0).blue)
      << "column 1 is the last of segment 1";
}

TEST(SegmentPicture, IsTheSameEveryTime) {
  const DepthImage image = depth_image(wall_view, wall_labels);
  EXPECT_EQ(segment_picture(image).pixels, segment_picture(image).pixels);
}

TEST(SideBySide, PutsBothNextToEachOther) {
  const DepthImage image = depth_image(wall_view, wall_labels);
  const Picture left = depth_picture(image);
  const Picture right = segment_picture(image);
  const Picture both = side_by_side(left, right);
  ASSERT_EQ(both.width, 8U);
  ASSERT_EQ(both.height, 2U);
  for (std::uint32_t row = 0; row < 2; ++row) {
    for (std::uint32_t column = 0; column < 4; ++column) {
      EXPECT_EQ(both.at(column, row), left.at(column, row));
      EXPECT_EQ(both.at(column + 4, row), right.at(column, row));
    }
  }
}

TEST(Projection, ShowsTheNearestOfPointsInOneLine) {
  std::vector<float> xyz;
  std::vector<std::uint16_t> labels;
  for (const float depth_m : {3.0F, 1.0F, 2.0F}) {
    for (int i = 0; i < 20; ++i) {
      for (int j = 0; j < 20; ++j) {
        const float u = static_cast<float>(i) / 20;
        const float v = static_cast<float>(j) / 20;
        xyz.insert(xyz.end(), {u * depth_m, v * depth_m, depth_m});
        labels.push_back(static_cast<std::uint16_t>(depth_m));
      }
    }
  }
  const DepthImage image = depth_image({.xyz = xyz.data(),
                                        .stride = 3,
                                        .width = static_cast<std::uint32_t>(labels.size()),
                                        .height = 1},
                                       labels);
  EXPECT_EQ(image.width, 640U);
  EXPECT_EQ(image.height, 480U);
  std::size_t painted = 0;
  for (std::size_t i = 0; i < image.depth_m.size(); ++i) {
    if (!std::isfinite(image.depth_m[i])) continue;
    ++painted;
    EXPECT_EQ(image.depth_m[i], 1);
    EXPECT_EQ(image.label[i], 1);
  }
  EXPECT_GT(painted, 400U * 16) << "sparse points get more than a pixel";
}

TEST(Projection, TakesAnyPointsWithoutHarm) {
  constexpr float huge = 1e30F;
  const std::vector<float> xyz = {nan, 0,     1, huge, huge, 1e-30F, 0, 0,     -1,
                                  0,   -huge, 2, 0,    0,    0,      1, -0.0F, huge};
  const std::vector<std::uint16_t> labels(6, 1);
  const DepthImage image =
      depth_image({.xyz = xyz.data(), .stride = 3, .width = 6, .height = 1}, labels);
  EXPECT_EQ(image.depth_m.size(), 640U * 480);
  EXPECT_EQ(segment_picture(image).pixels.size(), 640U * 480);
  const std::vector<float> none = {nan, nan, nan};
  const DepthImage empty =
      depth_image({.xyz = none.data(), .stride = 3, .width = 1, .height = 1}, labels);
  EXPECT_EQ(depth_picture(empty).at(320, 240), black);
}

TEST(PngFile, HoldsThePixelsThatWereGiven) {
  const tests::TemporaryFolder folder;
  const auto file = folder.path() / "picture.png";
  const Picture picture = segment_picture(depth_image(wall_view, wall_labels));
  write_png(file, picture);

  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_file(&image, file.c_str()), 0);
  image.format = PNG_FORMAT_RGB;
  ASSERT_EQ(image.width, 4U);
  ASSERT_EQ(image.height, 2U);
  std::vector<Rgb> pixels(8);
  ASSERT_NE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr), 0);
  EXPECT_EQ(pixels, picture.pixels);
}

}  // namespace
}  // namespace cleave
