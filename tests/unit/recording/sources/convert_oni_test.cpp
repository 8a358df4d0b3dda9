// SPDX-License-Identifier: BSD-3-Clause
// .oni recordings that become frames, and what the grabber makes of the same files.
#include <gtest/gtest.h>

#include <cmath>

#include "recording/oni/oni_reader.hpp"
#include "recording/sources/frame_sink.hpp"
#include "recording/sources/frame_source.hpp"
#include "sensor/sources/oni_source.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/recording/oni/oni_file.hpp"
#include "tests/unit/recording/recording_files.hpp"

namespace cleave::recording {
namespace {

using oni::test::OniFile;
using recording::Cloud;

OniFile example(std::size_t frames, std::uint32_t width = 16, std::uint32_t height = 12) {
  OniFile file;
  for (std::uint32_t i = 0; i < frames; ++i) {
    file.frames.push_back(oni::test::example_image(width, height, i));
  }
  return file;
}

std::vector<Cloud> clouds_of(recording::FrameSource& source) {
  std::vector<Cloud> clouds;
  while (auto frame = source.next()) {
    EXPECT_EQ(frame->log_time_ns, frame->header().capture_time_ns);
    clouds.push_back(std::get<Cloud>(std::move(frame->content)));
  }
  return clouds;
}

class ConvertOni : public testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path file(const std::string& bytes) const {
    return folder_.file("a.oni", bytes);
  }
  // All frames of the converted recording are those that the grabber makes of it.
  void expect_as_grabbed(const OniFile& recording) const {
    const std::filesystem::path input = file(recording.bytes());
    const std::filesystem::path output = folder_.path() / "a.mcap";
    const auto sink = recording::open_frame_sink(output);
    const auto source = recording::open_frame_source(input, "camera");
    while (auto frame = source->next()) sink->write(std::move(*frame));
    sink->close();
    const std::vector<Cloud> clouds = clouds_of(*recording::open_frame_source(output, "camera"));
    ASSERT_EQ(clouds.size(), recording.frames.size());
    sensor::OniSource grabbed(input, false);
    ASSERT_EQ(grabbed.open(), std::nullopt);
    sensor::Frame frame;
    for (const Cloud& cloud : clouds) {
      ASSERT_EQ(grabbed.next({}, frame), sensor::Poll::frame);
      const recording::FrameHeader& header = cloud.header;
      EXPECT_EQ(header.width, frame.width);
      EXPECT_EQ(header.height, frame.height);
      EXPECT_EQ((recording::Intrinsics{header.fx, header.fy, header.cx, header.cy}),
                frame.intrinsics);
      EXPECT_EQ(header.device_time_us, frame.device_time_us);
      std::vector<float> xyz(cloud.xyz.size());
      grabbed.write_points(xyz.data());
      EXPECT_TRUE(recording::same_points(cloud.xyz, xyz));
    }
  }

  tests::TemporaryFolder folder_;
};

TEST_F(ConvertOni, GivesThePointsOfTheDepthAndTheFieldsOfView) {
  const std::filesystem::path path = file(example(2).bytes());
  oni::Reader reader(path);
  oni::DepthFrame depth;
  const double fx = 16 / (2 * std::tan(1.0226 / 2));
  const double fy = 12 / (2 * std::tan(0.7966 / 2));
  const std::vector<Cloud> clouds = clouds_of(*recording::open_frame_source(path, "camera"));
  ASSERT_EQ(clouds.size(), 2U);
  for (std::size_t i = 0; i < clouds.size(); ++i) {
    ASSERT_EQ(reader.read(i, depth), std::nullopt);
    for (std::size_t p = 0; p < depth.depth.size(); ++p) {
      const float* const point = &clouds[i].xyz[3 * p];
      if (depth.depth[p] == 0) {
        ASSERT_TRUE(std::isnan(point[0]) && std::isnan(point[1]) && std::isnan(point[2]));
        continue;
      }
      const double z = depth.depth[p] * 0.001;
      ASSERT_NEAR(point[0], (static_cast<double>(p % 16) - 7.5) / fx * z, 1e-6);
      ASSERT_NEAR(point[1], (static_cast<double>(p / 16) - 5.5) / fy * z, 1e-6);
      ASSERT_NEAR(point[2], z, 1e-6);
    }
  }
}

TEST_F(ConvertOni, CountsFramesFromOneAndTimeFromZeroAndKeepsDeviceTimes) {
  OniFile recording = example(3);
  recording.first_timestamp_us = 5'000'000;
  const auto clouds = clouds_of(*recording::open_frame_source(file(recording.bytes()), "left"));
  ASSERT_EQ(clouds.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const recording::FrameHeader& header = clouds[i].header;
    EXPECT_EQ(header.frame_id, i + 1);
    EXPECT_EQ(header.capture_time_ns, static_cast<std::int64_t>(i) * 33'333'000);
    EXPECT_EQ(header.device_time_us, 5'000'000 + i * 33'333);
    EXPECT_EQ(header.sensor, "left");
    EXPECT_EQ(header.coordinate_frame, "left_optical");
  }
}

TEST_F(ConvertOni, GivesThePointsThatTheGrabberPublishes) {
  expect_as_grabbed(example(3));
}

TEST_F(ConvertOni, GivesThePointsThatTheGrabberPublishesInTenthsOfMillimetres) {
  OniFile recording = example(2);
  recording.pixel_format = 101;
  expect_as_grabbed(recording);
}

TEST_F(ConvertOni, KeepsThePrincipalPointWhereAnImageIsCropped) {
  OniFile recording = example(2, 8, 6);
  recording.cropping = {4, 2, 8, 6};
  expect_as_grabbed(recording);
  const auto clouds = clouds_of(*recording::open_frame_source(folder_.path() / "a.oni", "camera"));
  EXPECT_FLOAT_EQ(clouds.at(0).header.cx, 7.5F - 4);
  EXPECT_FLOAT_EQ(clouds.at(0).header.cy, 5.5F - 2);
}

TEST_F(ConvertOni, TurnsAMirroredRecordingBackCroppedOrNot) {
  OniFile whole = example(2);
  whole.mirrored = true;
  expect_as_grabbed(whole);
  const auto clouds = clouds_of(*recording::open_frame_source(folder_.path() / "a.oni", "camera"));
  EXPECT_FLOAT_EQ(clouds.at(0).header.cx, 7.5F);
  for (std::size_t u = 0; u < 16; ++u) {
    const std::uint16_t depth = whole.frames[0][15 - u];
    if (depth == 0) continue;
    EXPECT_FLOAT_EQ(clouds[0].xyz[3 * u + 2], static_cast<float>(depth) * 1e-3F);
    EXPECT_EQ(clouds[0].xyz[3 * u] > 0, u > 7) << "x is to the right";
  }
  std::filesystem::remove(folder_.path() / "a.mcap");
  OniFile cropped = example(1, 8, 6);
  cropped.cropping = {5, 2, 8, 6};
  cropped.mirrored = true;
  expect_as_grabbed(cropped);
}

TEST_F(ConvertOni, SkipsAndCountsDamagedFrames) {
  std::vector<std::size_t> starts;
  std::string content = example(4).bytes(&starts);
  content[starts[1] + 28 + 12] = content[starts[1] + 28 + 13] = '\xff';  // pixels
  content[starts[2] + 28 + 7] = '\xff';                                  // time stamp
  const auto source = recording::open_frame_source(file(content), "camera");
  const auto clouds = clouds_of(*source);
  ASSERT_EQ(clouds.size(), 2U);
  EXPECT_EQ(source->skipped(), 2U);
  EXPECT_EQ(clouds[1].header.frame_id, 2U);
  EXPECT_EQ(clouds[1].header.device_time_us, 3 * 33333U);
}

TEST_F(ConvertOni, CountsThatAFileWasCutOff) {
  OniFile recording = example(2);
  recording.with_end = false;
  const auto source = recording::open_frame_source(file(recording.bytes()), "camera");
  EXPECT_EQ(clouds_of(*source).size(), 2U);
  EXPECT_EQ(source->skipped(), 1U);
}

TEST_F(ConvertOni, TakesImagesOfAnySizeAndDecimatesThem) {
  OniFile recording = example(1, 848, 480);
  recording.width = 848;
  recording.height = 480;
  const std::filesystem::path path = file(recording.bytes());
  const auto whole = clouds_of(*open_frame_source(path, "camera"));
  ASSERT_EQ(whole.size(), 1U);
  EXPECT_EQ(whole[0].header.width, 848U);
  const auto thinned = clouds_of(*open_frame_source(path, "camera", {}, 2));
  ASSERT_EQ(thinned.size(), 1U);
  EXPECT_EQ(thinned[0].header.width, 424U);
  EXPECT_EQ(thinned[0].header.height, 240U);
}

TEST_F(ConvertOni, SaysWhyARecordingCannotBeConverted) {
  const auto failure = [this](const std::string& bytes) -> std::string {
    try {
      (void)recording::open_frame_source(file(bytes), "camera");
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(failure("text").find("cannot read the recording"), std::string::npos);
  EXPECT_NE(failure(example(0).bytes()).find("it has no frame"), std::string::npos);
  OniFile blind = example(1);
  blind.with_fov = false;
  EXPECT_NE(failure(blind.bytes()).find("field of view"), std::string::npos);
}

}  // namespace
}  // namespace cleave::recording
