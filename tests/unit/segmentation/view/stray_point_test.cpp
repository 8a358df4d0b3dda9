// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "stored_scene.hpp"
#include "tests/unit/segmentation/support/depth_scene.hpp"
#include "tests/unit/segmentation/support/segmented.hpp"

namespace cleave::segmentation {
namespace {

using Point = std::array<float, 3>;

// The labels with `point` in place of every so-manieth measured one are those with NaN there.
void expect_no_harm_of(const Point& point, std::size_t strays, std::uint32_t height,
                       const Options& options) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const DepthScene scene(3);
  std::vector<float> without = scene.xyz, with = scene.xyz;
  for (std::size_t k = 0; k < strays; ++k) {
    const std::size_t i = (2 * k + 1) * scene.view().size() / (2 * strays) + 7;
    std::fill_n(&without[3 * i], 3, nan);
    std::copy(point.begin(), point.end(), &with[3 * i]);
  }
  const std::uint32_t width = scene.width * scene.height / height;
  EXPECT_EQ(segmented({with.data(), 3, width, height}, options).labels,
            segmented({without.data(), 3, width, height}, options).labels)
      << point[2] << ", " << strays << " strays, height " << height;
}

void expect_no_harm_of(const Point& point, std::size_t strays) {
  for (const Representation representation : {Representation::cells, Representation::voxels}) {
    Options options;
    options.representation = representation;
    for (const std::uint32_t height : {120U, 1U}) expect_no_harm_of(point, strays, height, options);
  }
}

TEST(StrayPoint, OnOrBehindTheSensorChangesNoOther) {
  for (const Point& point : {Point{0, 0, -1}, Point{0.3F, 0.2F, 0}, Point{-5, 2, -1e-6F},
                             Point{1e30F, -1e30F, -1e30F}}) {
    expect_no_harm_of(point, 1);
  }
}

TEST(StrayPoint, MayBeOneInAThousand) {
  expect_no_harm_of({0, 0, -1}, 18);  // of 18,800
}

TEST(StrayPoint, MayBeOneInThreeHundredInAnImageThatIsMadeIntoVoxels) {
  Options options;
  options.representation = Representation::voxels;

  expect_no_harm_of({0.3F, 0.2F, -1}, 63, 120, options);
}

TEST(StrayPoint, MayBeAnyPartOfACloudThatIsSaidToBeSeenFromOneViewpoint) {
  Options options;
  options.voxel.viewpoint = Viewpoint::single;

  expect_no_harm_of({0.3F, 0.2F, -1}, 900, 1, options);
}

TEST(StrayPoint, MayLieWhereTheSensorStandsInHalfOfTheImage) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr Point sensor = {0.5F, 0.25F, 0.125F};
  DepthScene scene(3);
  for (std::uint32_t row = 0; row < scene.height; ++row) {
    for (std::uint32_t column = 0; column < scene.width / 2; ++column) {
      float* p = &scene.xyz[3 * (std::size_t{row} * scene.width + column)];
      std::copy(sensor.begin(), sensor.end(), p);
      if (row < 20) std::fill_n(p, 3, nan);
    }
  }
  CloudView view = scene.view();
  view.pose = SensorPose{.position_m = {sensor[0], sensor[1], sensor[2]}};

  EXPECT_FALSE(segmented(view).segmentation.segments.empty());
}

}  // namespace
}  // namespace cleave::segmentation
