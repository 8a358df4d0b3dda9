// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/sources/calibrated_source.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/unit/grabber/one_frame.hpp"

namespace cleave::sensor {
namespace {

using test::OneFrame;

std::vector<float> points_of(CalibratedSource& source, Frame& frame) {
  EXPECT_EQ(source.next(std::chrono::milliseconds(1), frame), Poll::frame);
  std::vector<float> xyz(3 * std::size_t{frame.width} * frame.height);
  source.write_points(xyz.data());
  return xyz;
}

TEST(CalibratedSource, DrawsEachPixelsRayAnewAndScalesItsDepth) {
  const Calibration calibration{{2, 4, 1, .5F}, 2};
  CalibratedSource source(std::make_unique<OneFrame>(2, 2), calibration);
  Frame frame;
  const std::vector<float> xyz = points_of(source, frame);
  EXPECT_EQ(frame.intrinsics, calibration.intrinsics);
  EXPECT_EQ(xyz, (std::vector<float>{-1, -.25F, 2, 0, -.25F, 2, -1, .25F, 2, 0, .25F, 2}));
}

TEST(CalibratedSource, KeepsTheSourcesRaysWhereItKnowsNoOthers) {
  CalibratedSource source(std::make_unique<OneFrame>(2, 1), {{}, .5F});
  Frame frame;
  const std::vector<float> xyz = points_of(source, frame);
  EXPECT_EQ(frame.intrinsics, (Intrinsics{100, 100, 1.5F, .5F}));
  EXPECT_EQ(xyz, (std::vector<float>{0, 0, .5F, .5F, 0, .5F}));
}

TEST(CalibratedSource, ScalesACloudThatIsNoImageAndGivesItNoRays) {
  CalibratedSource source(std::make_unique<OneFrame>(2, 1, Intrinsics{}), {{2, 4, 1, .5F}, 2});
  Frame frame;
  const std::vector<float> xyz = points_of(source, frame);
  EXPECT_EQ(frame.intrinsics, Intrinsics{});
  EXPECT_EQ(xyz, (std::vector<float>{0, 0, 2, 2, 0, 2}));
}

TEST(CalibratedSource, PassesCountsErrorsAndTheEndOn) {
  CalibratedSource source(std::make_unique<OneFrame>(2, 1), {{}, 2});
  Frame frame;
  (void)points_of(source, frame);
  EXPECT_EQ(source.counts().sensor_drops, 3U);
  EXPECT_EQ(source.last_error(), "none");
  EXPECT_EQ(source.next(std::chrono::milliseconds(1), frame), Poll::end);
}

}  // namespace
}  // namespace cleave::sensor
