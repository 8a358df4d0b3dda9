// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/sources/decimating_source.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace cleave::sensor {
namespace {

// One frame of points (i, 0, 1).
class OneFrame : public Source {
 public:
  OneFrame(std::uint32_t width, std::uint32_t height) : width_(width), height_(height) {}

  [[nodiscard]] Failure open() override { return std::nullopt; }
  [[nodiscard]] Poll next(std::chrono::milliseconds /*timeout*/, Frame& frame) override {
    if (std::exchange(given_, true)) return Poll::end;
    frame = {width_, height_, {100, 100, 1.5F, .5F}, 7, 9, true};
    return Poll::frame;
  }
  void write_points(float* xyz) override {
    for (std::uint32_t i = 0; i < width_ * height_; ++i, xyz += 3) {
      std::copy_n(std::array{static_cast<float>(i), 0.0F, 1.0F}.data(), 3, xyz);
    }
  }
  [[nodiscard]] bool realtime() const override { return false; }
  [[nodiscard]] SourceCounts counts() const override { return {3, {}}; }
  [[nodiscard]] std::string last_error() const override { return "none"; }

 private:
  std::uint32_t width_, height_;
  bool given_ = false;
};

TEST(DecimatingSource, MakesAnImageSmallerAndKeepsTimesCountsAndEnds) {
  DecimatingSource source(std::make_unique<OneFrame>(4, 2), 2);
  Frame frame;
  ASSERT_EQ(source.next(std::chrono::milliseconds(1), frame), Poll::frame);
  EXPECT_EQ(frame.width, 2U);
  EXPECT_EQ(frame.height, 1U);
  EXPECT_EQ(frame.intrinsics, (Intrinsics{50, 50, .5F, 0}));
  EXPECT_EQ(frame.capture_time_ns, 7);
  EXPECT_EQ(frame.device_time_us, 9U);
  EXPECT_TRUE(frame.begins_epoch);
  std::vector<float> xyz(6);
  source.write_points(xyz.data());
  EXPECT_EQ(xyz, (std::vector<float>{-.01F, 0, 1, .01F, 0, 1}));
  EXPECT_EQ(source.counts().sensor_drops, 3U);
  EXPECT_EQ(source.next(std::chrono::milliseconds(1), frame), Poll::end);
}

TEST(DecimatingSource, LeavesACloudThatIsNoImageAsItIs) {
  DecimatingSource source(std::make_unique<OneFrame>(3, 1), 2);
  Frame frame;
  ASSERT_EQ(source.next(std::chrono::milliseconds(1), frame), Poll::frame);
  EXPECT_EQ(frame.width, 3U);
  std::vector<float> xyz(9);
  source.write_points(xyz.data());
  EXPECT_EQ(xyz, (std::vector<float>{0, 0, 1, 1, 0, 1, 2, 0, 1}));
}

}  // namespace
}  // namespace cleave::sensor
