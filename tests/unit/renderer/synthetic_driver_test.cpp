// SPDX-License-Identifier: BSD-3-Clause
// The synthetic camera through Debian's OpenNI2: one initialisation for the whole program, as
// OpenNI2 allows no more.
#include <OpenNI.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "sensor/renderer/scene/scene_loop.hpp"

namespace cleave::render {
namespace {

class SyntheticDriver : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    ASSERT_EQ(openni::OpenNI::initialize(), openni::STATUS_OK)
        << openni::OpenNI::getExtendedError();
  }
  static void TearDownTestSuite() { openni::OpenNI::shutdown(); }

  void open(const char* uri) {
    ASSERT_EQ(device_.open(uri), openni::STATUS_OK) << openni::OpenNI::getExtendedError();
    ASSERT_EQ(stream_.create(device_, openni::SENSOR_DEPTH), openni::STATUS_OK)
        << openni::OpenNI::getExtendedError();
  }

  void TearDown() override {
    stream_.stop();
    stream_.destroy();
    device_.close();
  }

  // The next frame; an invalid one if none comes for 30 seconds.
  openni::VideoFrameRef next_frame() {
    openni::VideoStream* streams[] = {&stream_};
    int ready = -1;
    openni::VideoFrameRef frame;
    if (openni::OpenNI::waitForAnyStream(streams, 1, &ready, 30000) == openni::STATUS_OK) {
      stream_.readFrame(&frame);
    }
    return frame;
  }

  openni::Device device_;
  openni::VideoStream stream_;
};

std::vector<std::uint16_t> depth_of(const openni::VideoFrameRef& frame) {
  const auto* const first = static_cast<const std::uint16_t*>(frame.getData());
  return {first, first + frame.getDataSize() / 2};
}

TEST_F(SyntheticDriver, DeliversTheRenderersFramesInOrder) {
  open("synthetic:simple?seed=3&frames=4");
  SceneLoop loop(parse_scene("simple?seed=3&frames=4"));
  std::vector<std::vector<std::uint16_t>> expected;
  for (std::uint32_t i = 0; i < loop.size(); ++i) expected.push_back(loop.frame(i).depth_mm);

  ASSERT_EQ(stream_.start(), openni::STATUS_OK);
  openni::VideoFrameRef last = next_frame();
  ASSERT_TRUE(last.isValid());
  EXPECT_EQ(depth_of(last), expected[0]);
  int in_a_row = 0;
  for (int i = 0; i < 20; ++i) {
    openni::VideoFrameRef frame = next_frame();
    ASSERT_TRUE(frame.isValid());
    EXPECT_GT(frame.getFrameIndex(), last.getFrameIndex());
    EXPECT_GT(frame.getTimestamp(), last.getTimestamp());
    const auto shown = std::ranges::find(expected, depth_of(frame));
    ASSERT_NE(shown, expected.end()) << "frame " << i << " is none of the loop's";
    // OpenNI2 hands out the newest frame: on a busy machine some are passed over.
    if (frame.getFrameIndex() == last.getFrameIndex() + 1) {
      ++in_a_row;
      const auto before = std::ranges::find(expected, depth_of(last));
      const auto next = before + 1 == expected.end() ? expected.begin() : before + 1;
      EXPECT_TRUE(shown == next || shown == before);  // the same while the next is not rendered
    }
    last = frame;
  }
  EXPECT_GT(in_a_row, 0);
}

TEST_F(SyntheticDriver, HasThePinholeOfThePrimeSenseCameras) {
  open("synthetic:simple");
  const double fx = 640 / (2 * std::tan(stream_.getHorizontalFieldOfView() / 2));
  const double fy = 480 / (2 * std::tan(stream_.getVerticalFieldOfView() / 2));
  EXPECT_NEAR(fx, 525, 1e-3);
  EXPECT_NEAR(fy, 525, 1e-3);
}

TEST_F(SyntheticDriver, HasOneVideoModeOfTheRateAskedFor) {
  open("synthetic:simple?fps=15");
  const openni::VideoMode mode = stream_.getVideoMode();
  EXPECT_EQ(mode.getPixelFormat(), openni::PIXEL_FORMAT_DEPTH_1_MM);
  EXPECT_EQ(mode.getResolutionX(), 640);
  EXPECT_EQ(mode.getResolutionY(), 480);
  EXPECT_EQ(mode.getFps(), 15);
  EXPECT_EQ(stream_.setVideoMode(mode), openni::STATUS_OK);
  openni::VideoMode other = mode;
  other.setFps(30);
  EXPECT_NE(stream_.setVideoMode(other), openni::STATUS_OK);
}

TEST_F(SyntheticDriver, AnswersWhatGrabbersAsk) {
  open("synthetic:medium?seed=9");
  EXPECT_EQ(stream_.getMaxPixelValue(), 10000);
  EXPECT_EQ(stream_.getMinPixelValue(), 0);
  EXPECT_FALSE(stream_.getMirroringEnabled());
  EXPECT_EQ(stream_.setMirroringEnabled(false), openni::STATUS_OK);
  EXPECT_EQ(stream_.setMirroringEnabled(true), openni::STATUS_OK);
  EXPECT_TRUE(stream_.getMirroringEnabled());
  EXPECT_TRUE(device_.isImageRegistrationModeSupported(openni::IMAGE_REGISTRATION_OFF));
  EXPECT_FALSE(device_.isImageRegistrationModeSupported(openni::IMAGE_REGISTRATION_DEPTH_TO_COLOR));
  EXPECT_TRUE(stream_.isCroppingSupported());
  EXPECT_EQ(device_.getDeviceInfo().getUri(), std::string("synthetic:medium?seed=9"));
  char serial[64];
  int size = sizeof serial;
  EXPECT_EQ(device_.getProperty(openni::DEVICE_PROPERTY_SERIAL_NUMBER, serial, &size),
            openni::STATUS_OK);
  EXPECT_STREQ(serial, "medium?seed=9");
}

TEST_F(SyntheticDriver, StartsAgainFromTheFirstFrameAfterAStop) {
  open("synthetic:simple?seed=2&frames=2");
  SceneLoop loop(parse_scene("simple?seed=2&frames=2"));
  for (int run = 0; run < 3; ++run) {
    ASSERT_EQ(stream_.start(), openni::STATUS_OK);
    const openni::VideoFrameRef frame = next_frame();
    ASSERT_TRUE(frame.isValid());
    // On a busy machine OpenNI2 hands out a later one than the first: its number says which.
    const auto place = static_cast<std::uint32_t>(frame.getFrameIndex() - 1) % 2;
    EXPECT_EQ(depth_of(frame), loop.frame(place).depth_mm) << "run " << run;
    stream_.stop();
  }
}

// The whole loop takes minutes to render, longer than next_frame() waits.
TEST_F(SyntheticDriver, AMovingCamerasFramesComeInOrderWhileTheRestIsStillRendered) {
  open("synthetic:crowded?seed=2&motion=1&frames=600&fps=60");
  SceneLoop loop(parse_scene("crowded?seed=2&motion=1&frames=600"));
  ASSERT_EQ(stream_.start(), openni::STATUS_OK);

  // A frame is shown again until the next one is rendered.
  constexpr int patience = 20 * 60;  // frames: 20 s
  std::uint32_t shown = 0;
  for (int i = 0; shown < 2 && i < patience; ++i) {
    const openni::VideoFrameRef frame = next_frame();
    ASSERT_TRUE(frame.isValid());
    const std::vector<std::uint16_t> depth_mm = depth_of(frame);
    while (depth_mm != loop.frame(shown).depth_mm) {
      ASSERT_LT(++shown, loop.size()) << "frame " << i << " is none of the loop's from there on";
    }
  }
  EXPECT_GE(shown, 2U) << "it moves";
}

TEST_F(SyntheticDriver, ABadSceneIsRefusedWithAReadableError) {
  EXPECT_NE(device_.open("synthetic:simple?sead=1"), openni::STATUS_OK);
  const std::string error = openni::OpenNI::getExtendedError();
  EXPECT_NE(error.find("unknown key \"sead\""), std::string::npos) << error;
}

TEST_F(SyntheticDriver, ANameThatOpenNI2CannotHoldIsRefused) {
  std::string uri = "synthetic:simple?seed=";
  uri.append(300 - uri.size(), '0');
  EXPECT_NE(device_.open(uri.c_str()), openni::STATUS_OK);
}

}  // namespace
}  // namespace cleave::render
