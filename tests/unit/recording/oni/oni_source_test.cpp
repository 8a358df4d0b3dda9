// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/sources/oni_source.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "sensor/sources/make_source.hpp"
#include "tests/unit/recording/oni/oni_file.hpp"

namespace cleave::sensor {
namespace {

using oni::test::OniFile;
using oni::test::TestFile;

OniFile example(std::uint32_t frames) {
  OniFile file;
  for (std::uint32_t i = 0; i < frames; ++i) {
    file.frames.push_back(oni::test::example_image(file.width, file.height, i));
  }
  return file;
}

std::vector<float> points(Source& source, const Frame& frame) {
  std::vector<float> xyz(3 * std::size_t{frame.width} * frame.height);
  source.write_points(xyz.data());
  return xyz;
}

TEST(OniSource, PlaysEveryFrameOnceAndEnds) {
  const OniFile recording = example(3);
  const TestFile file(recording.bytes());
  OniSource source(file.path(), false);
  ASSERT_EQ(source.open(), std::nullopt);
  EXPECT_FALSE(source.realtime());
  Frame frame;
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_EQ(source.next({}, frame), Poll::frame);
    EXPECT_EQ(frame.device_time_us, 33333 * i);
    EXPECT_FALSE(frame.begins_epoch);
    const std::vector<float> xyz = points(source, frame);
    for (std::size_t p = 0; p < recording.frames[i].size(); ++p) {
      const std::uint16_t depth = recording.frames[i][p];
      if (depth == 0) {
        ASSERT_TRUE(std::isnan(xyz[3 * p + 2]));
      } else {
        ASSERT_FLOAT_EQ(xyz[3 * p + 2], static_cast<float>(depth) * 1e-3F);
      }
    }
    EXPECT_EQ(points(source, frame).size(), xyz.size()) << "points may be asked for again";
  }
  EXPECT_EQ(source.next({}, frame), Poll::end);
}

TEST(OniSource, BeginsAnEpochWithEveryLoop) {
  const TestFile file(example(2).bytes());
  OniSource source(file.path(), true);
  ASSERT_EQ(source.open(), std::nullopt);
  Frame frame;
  std::vector<bool> begins;
  for (int i = 0; i < 5; ++i) {
    ASSERT_EQ(source.next({}, frame), Poll::frame);
    begins.push_back(frame.begins_epoch);
  }
  EXPECT_EQ(begins, (std::vector<bool>{false, false, true, false, true}));
}

TEST(OniSource, TurnsAMirroredRecordingBack) {
  OniFile recording;
  recording.frames = {oni::test::Image(std::size_t{16} * 12, 0)};
  recording.frames[0][1] = 1000;
  recording.mirrored = true;
  const TestFile file(recording.bytes());
  OniSource source(file.path(), false);
  ASSERT_EQ(source.open(), std::nullopt);
  Frame frame;
  ASSERT_EQ(source.next({}, frame), Poll::frame);
  const std::vector<float> xyz = points(source, frame);
  EXPECT_EQ(xyz[3 * 14 + 2], 1.0F);
  EXPECT_GT(xyz[3 * 14], 0) << "x is to the right";
  EXPECT_TRUE(std::isnan(xyz[3 * 1 + 2]));
  EXPECT_EQ(points(source, frame)[3 * 14 + 2], 1.0F) << "points may be asked for again";
}

TEST(OniSource, KeepsThePrincipalPointWhereAnImageIsCropped) {
  OniFile recording;
  recording.cropping = {4, 2, 8, 6};
  recording.frames = {oni::test::Image(std::size_t{8} * 6, 1000)};
  const TestFile file(recording.bytes());
  OniSource source(file.path(), false);
  ASSERT_EQ(source.open(), std::nullopt);
  Frame frame;
  ASSERT_EQ(source.next({}, frame), Poll::frame);
  EXPECT_EQ(frame.width, 8U);
  EXPECT_FLOAT_EQ(frame.intrinsics.cx, 7.5F - 4);
  EXPECT_FLOAT_EQ(frame.intrinsics.cy, 5.5F - 2);
}

TEST(OniSource, SkipsAndCountsDamagedFrames) {
  std::vector<std::size_t> starts;
  std::string content = example(3).bytes(&starts);
  content[starts[1] + 28 + 12] = content[starts[1] + 28 + 13] = '\xff';
  const TestFile file(content);
  OniSource source(file.path(), false);
  ASSERT_EQ(source.open(), std::nullopt);
  Frame frame;
  EXPECT_EQ(source.next({}, frame), Poll::frame);
  EXPECT_EQ(source.next({}, frame), Poll::frame);
  EXPECT_EQ(frame.device_time_us, 2 * 33333U);
  EXPECT_EQ(source.next({}, frame), Poll::end);
  EXPECT_EQ(source.counts().unusable.at("damaged frame"), 1U);
}

TEST(OniSource, EndsWhereALoopHasNoFrameThatIsWhole) {
  std::vector<std::size_t> starts;
  std::string content = example(1).bytes(&starts);
  content[starts[0] + 28 + 12] = content[starts[0] + 28 + 13] = '\xff';
  const TestFile file(content);
  OniSource source(file.path(), true);
  ASSERT_EQ(source.open(), std::nullopt);
  Frame frame;
  EXPECT_EQ(source.next({}, frame), Poll::end);
}

TEST(OniSource, PlaysImagesOfAnySizeAndDecimatesThem) {
  OniFile recording;
  recording.width = 848;
  recording.height = 480;
  recording.frames = {oni::test::example_image(recording.width, recording.height, 1)};
  const TestFile file(recording.bytes());
  const auto source = make_source("oni:" + file.path().string(), {}, {}, {.decimate = 2});
  ASSERT_EQ(source->open(), std::nullopt);
  Frame frame;
  ASSERT_EQ(source->next({}, frame), Poll::frame);
  EXPECT_EQ(frame.width, 424U);
  EXPECT_EQ(frame.height, 240U);
  EXPECT_EQ(points(*source, frame).size(), 3U * 424 * 240);
}

TEST(OniSource, SaysWhyARecordingCannotBePlayed) {
  const auto failure = [](const OniFile& recording) {
    const TestFile file(recording.bytes());
    return OniSource(file.path(), false).open().value_or("");
  };
  EXPECT_NE(failure(example(0)).find("no frame"), std::string::npos);
  OniFile blind = example(1);
  blind.with_fov = false;
  EXPECT_NE(failure(blind).find("field of view"), std::string::npos);
  OniFile large = example(1);
  large.width = large.height = 1024;
  EXPECT_NE(failure(large).find("--decimate"), std::string::npos);
  EXPECT_NE(OniSource("/no/such.oni", false).open().value_or("").find("/no/such.oni"),
            std::string::npos);
}

}  // namespace
}  // namespace cleave::sensor
