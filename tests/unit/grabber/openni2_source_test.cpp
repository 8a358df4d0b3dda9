#include "sensor/openni2_source.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <vector>

#include "sensor/make_source.hpp"

namespace cleave::sensor {
namespace {

using std::chrono::milliseconds;

// OpenNI2 is initialised once a process, so the tests share it; each opens a camera of its own.
std::unique_ptr<Source> camera(const std::string& scene, std::uint32_t fps = 60) {
  return make_source("synthetic:" + scene, {640, 480, fps}, false);
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
  const auto source = make_source("synthetic:simple", {320, 240, 30}, false);
  const Failure failure = source->open();
  ASSERT_TRUE(failure);
  EXPECT_NE(failure->find("no depth mode 320x240@30, only 640x480@30"), std::string::npos)
      << *failure;
}

TEST(OpenNi2Source, SaysWhatToDoWhereNoCameraIs) {
  const auto source = make_source("openni2:1d27/0609@99/99", {}, false);
  const Failure failure = source->open();
  ASSERT_TRUE(failure);
  EXPECT_NE(failure->find("lsusb"), std::string::npos) << *failure;
}

TEST(OpenNi2Source, RefusesASceneThatTheDriverDoesNotKnow) {
  EXPECT_TRUE(camera("palace")->open());
}

TEST(OpenNi2Source, LeavesTheWorkingDirectoryAsItWas) {
  const std::filesystem::path here = std::filesystem::current_path();
  ASSERT_FALSE(camera("simple")->open());
  EXPECT_EQ(std::filesystem::current_path(), here);
}

}  // namespace
}  // namespace cleave::sensor
