// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/sources/openni2/openni2_source.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "sensor/sources/make_source.hpp"

namespace cleave::sensor {
namespace {

using std::chrono::milliseconds;

// OpenNI2 is initialised once a process, so the tests share it; each opens a camera of its own.
std::unique_ptr<Source> camera(const std::string& scene, std::uint32_t fps = 60) {
  return make_source("synthetic:" + scene, {640, 480, fps, false, false}, {});
}

// The next frame; the test's time-out is the only limit.
Frame next_frame(Source& source) {
  Frame frame;
  Poll poll = Poll::timeout;
  while (poll == Poll::timeout) poll = source.next(milliseconds(100), frame);
  EXPECT_EQ(poll, Poll::frame) << source.last_error();
  return frame;
}

TEST(OpenNi2Source, DeliversFramesWithIntrinsicsAndDeviceTime) {
  const auto source = camera("simple");
  const Failure failure = source->open();
  ASSERT_FALSE(failure) << *failure;
  const Frame first = next_frame(*source);
  EXPECT_EQ(first.width, 640U);
  EXPECT_EQ(first.height, 480U);
  EXPECT_NEAR(first.intrinsics.fx, 525, 1e-3);
  EXPECT_EQ(first.intrinsics.cx, 319.5F);
  const Frame second = next_frame(*source);
  EXPECT_GT(second.device_time_us, first.device_time_us);
  EXPECT_FALSE(second.begins_epoch);
}

TEST(OpenNi2Source, WritesThePointsOfATableInFrontOfTheCamera) {
  const auto source = camera("simple?noise=0");
  ASSERT_FALSE(source->open());
  const Frame frame = next_frame(*source);
  std::vector<float> xyz(3 * std::size_t{frame.width} * frame.height);
  source->write_points(xyz.data());
  std::size_t measured = 0;
  for (std::size_t i = 0; i < xyz.size(); i += 3) {
    if (std::isnan(xyz[i + 2])) continue;
    ++measured;
    const auto u = static_cast<float>(i / 3 % frame.width);
    ASSERT_GT(xyz[i + 2], 0);
    ASSERT_NEAR(xyz[i], (u - 319.5F) / 525 * xyz[i + 2], 1e-5);
  }
  EXPECT_GT(measured, xyz.size() / 3 / 4);
}

TEST(OpenNi2Source, OpensAgainAfterItWasOpen) {
  const auto source = camera("simple");
  ASSERT_FALSE(source->open());
  (void)next_frame(*source);
  ASSERT_FALSE(source->open());
  (void)next_frame(*source);
}

TEST(OpenNi2Source, TakesTheRateFromTheUriWhereItNamesOne) {
  EXPECT_FALSE(camera("simple?fps=10", 30)->open());
  EXPECT_FALSE(camera("simple?seed=2", 15)->open());
}

TEST(OpenNi2Source, NamesTheModesThatThereAre) {
  OpenNi2Source source("synthetic:simple", {320, 240, 30, false, false});
  const Failure failure = source.open();
  ASSERT_TRUE(failure);
  EXPECT_NE(failure->find("no depth mode 320x240@30, only 640x480@30"), std::string::npos)
      << *failure;
}

TEST(OpenNi2Source, DeliversImagesOfTheSizeAskedForAndOfTheUrisSize) {
  for (const char* const uri : {"synthetic:simple", "synthetic:simple?height=480&width=848"}) {
    const VideoMode mode = uri == std::string("synthetic:simple")
                               ? VideoMode{848, 480, 30, false, false}
                               : VideoMode{640, 480, 30, false, false};
    const auto source = make_source(uri, mode, {});
    ASSERT_FALSE(source->open());
    Frame frame;
    ASSERT_EQ(source->next(std::chrono::seconds(20), frame), Poll::frame);
    EXPECT_EQ(frame.width, 848U);
    EXPECT_EQ(frame.height, 480U);
    EXPECT_NEAR(frame.intrinsics.fx, 525.0 * 848 / 640, .01);
  }
}

TEST(OpenNi2Source, SaysWhatToDoWhereNoCameraIs) {
  const auto source = make_source("openni2:1d27/0609@99/99", {}, {});
  const Failure failure = source->open();
  ASSERT_TRUE(failure);
  EXPECT_NE(failure->find("lsusb"), std::string::npos) << *failure;
}

TEST(OpenNi2Source, RefusesASceneThatTheDriverDoesNotKnow) {
  EXPECT_TRUE(camera("palace")->open());
}

// The next frame, or whatever else there is but a time-out.
Poll next_event(Source& source, Frame& frame) {
  Poll poll = Poll::timeout;
  while (poll == Poll::timeout) poll = source.next(milliseconds(50), frame);
  return poll;
}

// Opens the source for as long as it takes; how many attempts failed, and why the last one did.
std::pair<int, std::string> open_at_last(Source& source) {
  int failures = 0;
  std::string why;
  while (const Failure failure = source.open()) {
    ++failures;
    why = *failure;
    std::this_thread::sleep_for(milliseconds(50));
  }
  return {failures, why};
}

std::vector<float> points(Source& source, const Frame& frame) {
  std::vector<float> xyz(3 * std::size_t{frame.width} * frame.height);
  source.write_points(xyz.data());
  return xyz;
}

TEST(OpenNi2Source, IsLostWhenItIsUnpluggedAndOpensWhenItIsThereAgain) {
  const auto source = camera("simple?unplug_at_ms=500&replug_after_ms=300");
  ASSERT_FALSE(source->open());
  Frame frame;
  Poll poll = Poll::frame;
  while (poll == Poll::frame) poll = next_event(*source, frame);
  EXPECT_EQ(poll, Poll::lost);
  EXPECT_NE(source->last_error().find("disconnected"), std::string::npos) << source->last_error();
  const auto [failures, why] = open_at_last(*source);
  if (failures > 0) {
    EXPECT_NE(why.find("lsusb"), std::string::npos) << why;
  }
  EXPECT_FALSE(source->in_use());
  (void)next_frame(*source);
}

TEST(OpenNi2Source, IsLostWhenItFallsSilentAndSendsAgainAfterIt) {
  const auto source = camera("simple?stall_at_ms=500&stall_ms=1500");
  ASSERT_FALSE(source->open());
  Frame frame;
  Poll poll = Poll::frame;
  while (poll == Poll::frame) poll = next_event(*source, frame);
  EXPECT_EQ(poll, Poll::lost);
  EXPECT_NE(source->last_error().find("no frame for 800 ms"), std::string::npos)
      << source->last_error();
  ASSERT_FALSE(source->open());
  (void)next_frame(*source);
}

TEST(OpenNi2Source, SaysThatAnotherProgramHasTheCamera) {
  const auto source = camera("simple?in_use_ms=500");
  const Failure failure = source->open();
  ASSERT_TRUE(failure);
  EXPECT_NE(failure->find("does another program use it"), std::string::npos) << *failure;
  EXPECT_NE(failure->find("the camera is in use"), std::string::npos) << *failure;
  EXPECT_TRUE(source->in_use());
  (void)open_at_last(*source);
  EXPECT_FALSE(source->in_use());
  (void)next_frame(*source);
}

TEST(OpenNi2Source, BeginsAnEpochWhenTheClockIsReset) {
  const auto source = camera("simple?clock_reset_at_ms=500");
  ASSERT_FALSE(source->open());
  std::uint64_t before_us = 0;
  Frame frame = next_frame(*source);
  for (; !frame.begins_epoch; frame = next_frame(*source)) before_us = frame.device_time_us;
  EXPECT_LT(frame.device_time_us, before_us);
  EXPECT_FALSE(next_frame(*source).begins_epoch);
}

// Every frame that the device numbered was delivered or is counted: its clock ticks once a frame.
TEST(OpenNi2Source, CountsTheFramesThatTheDeviceNumberedAndNobodyGot) {
  const auto source = camera("simple?fps=20&drop_at_ms=500&drop_frames=7");
  ASSERT_FALSE(source->open());
  const std::uint64_t first_us = next_frame(*source).device_time_us;
  std::uint64_t frames = 1;
  std::uint64_t last_us = first_us;
  for (; source->counts().sensor_drops < 7; ++frames) last_us = next_frame(*source).device_time_us;
  EXPECT_EQ(frames + source->counts().sensor_drops, (last_us - first_us) / 50'000 + 1);
}

TEST(OpenNi2Source, TurnsMirroringOffUnlessItIsAskedFor) {
  const auto straight = camera("simple?noise=0");
  ASSERT_FALSE(straight->open());
  const std::vector<float> expected = points(*straight, next_frame(*straight));
  const auto mirrors = camera("simple?noise=0&mirrored=1");
  ASSERT_FALSE(mirrors->open());
  const std::vector<float> unmirrored = points(*mirrors, next_frame(*mirrors));
  EXPECT_EQ(std::memcmp(unmirrored.data(), expected.data(), 4 * expected.size()), 0);

  const auto wanted =
      make_source("synthetic:simple?noise=0&seed=1", {640, 480, 60, false, true}, {});
  ASSERT_FALSE(wanted->open());
  const std::vector<float> mirrored = points(*wanted, next_frame(*wanted));
  for (std::size_t row = 0; row < 480; ++row) {
    for (std::size_t u = 0; u < 640; ++u) {
      const float z = expected[3 * (640 * row + u) + 2];
      const float there = mirrored[3 * (640 * row + 639 - u) + 2];
      ASSERT_TRUE(z == there || (std::isnan(z) && std::isnan(there)));
    }
  }
}

TEST(OpenNi2Source, RefusesRegistrationWhereTheCameraHasNone) {
  const VideoMode registered{640, 480, 30, true, false};
  EXPECT_FALSE(make_source("synthetic:simple?registration=1", registered, {})->open());
  const Failure failure = make_source("synthetic:simple", registered, {})->open();
  ASSERT_TRUE(failure);
  EXPECT_NE(failure->find("video.registration"), std::string::npos) << *failure;
}

TEST(OpenNi2Source, FindsACameraByItsSerialNumber) {
  const auto by_serial = [](const std::string& serial) {
    return make_source("openni2:serial=" + serial, {640, 480, 30, false, false}, {});
  };
  const auto source = by_serial("medium?seed=7");
  const Failure failure = source->open();
  ASSERT_FALSE(failure) << *failure;
  (void)next_frame(*source);
  const Failure unknown = by_serial("4711")->open();
  ASSERT_TRUE(unknown);
  EXPECT_NE(unknown->find("none has the serial number '4711'"), std::string::npos) << *unknown;
  EXPECT_NE(unknown->find("'simple?seed=9' (synthetic:simple?seed=9)"), std::string::npos)
      << *unknown;
}

TEST(OpenNi2Source, LeavesTheWorkingDirectoryAsItWas) {
  const std::filesystem::path here = std::filesystem::current_path();
  ASSERT_FALSE(camera("simple")->open());
  EXPECT_EQ(std::filesystem::current_path(), here);
}

}  // namespace
}  // namespace cleave::sensor

// Two cameras are plugged in when OpenNI2 is initialised.
int main(int argc, char** argv) {
  ::setenv("CLEAVE_SYNTHETIC", "simple?seed=9 medium?seed=7", 1);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
