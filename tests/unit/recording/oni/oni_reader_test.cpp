// SPDX-License-Identifier: BSD-3-Clause
#include "recording/oni/oni_reader.hpp"

#include <gtest/gtest.h>

#include "tests/unit/recording/oni/oni_file.hpp"

namespace cleave::oni {
namespace {

using test::OniFile;
using test::TestFile;

OniFile readable_file(std::uint32_t frames = 5) {
  OniFile file;
  for (std::uint32_t i = 0; i < frames; ++i) {
    file.frames.push_back(test::example_image(file.width, file.height, i));
  }
  return file;
}

// What the constructor says of this file.
std::string refusal(const std::string& content) {
  const TestFile file(content);
  try {
    const Reader reader(file.path());
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find(file.path().string()), std::string::npos);
    return error.what();
  }
  return "";
}

// The recorded numbers of the frames that can be read, each checked pixel for pixel.
std::vector<std::uint32_t> intact(const OniFile& source, const std::string& content) {
  const TestFile file(content);
  Reader reader(file.path());
  std::vector<std::uint32_t> indices;
  DepthFrame frame;
  for (std::size_t i = 0; i < reader.size(); ++i) {
    if (reader.read(i, frame)) continue;
    EXPECT_EQ(frame.depth, source.frames.at(frame.index - 1));
    indices.push_back(frame.index);
  }
  return indices;
}

TEST(OniReader, GivesBackEveryFrameOfEveryCodecPixelForPixel) {
  for (const char* const codec : {"16zT", "16zP", "NONE"}) {
    for (const bool wide : {true, false}) {
      OniFile source = readable_file();
      source.codec = codec;
      source.wide = wide;
      const TestFile file(source.bytes());
      Reader reader(file.path());
      EXPECT_EQ(reader.damage(), "");
      ASSERT_EQ(reader.size(), 5U) << codec;
      DepthFrame frame;
      for (const std::size_t i : {4U, 0U, 2U, 2U, 1U, 3U}) {
        ASSERT_EQ(reader.read(i, frame), std::nullopt);
        EXPECT_EQ(frame.depth, source.frames[i]);
        EXPECT_EQ(frame.index, i + 1);
        EXPECT_EQ(frame.timestamp_us, 33333 * i);
        EXPECT_EQ(reader.timestamp_us(i), 33333 * i);
      }
    }
  }
}

TEST(OniReader, TellsSizeUnitFieldsOfViewAndMirroring) {
  OniFile source = readable_file(1);
  {
    const TestFile file(source.bytes());
    const DepthStream stream = Reader(file.path()).stream();
    EXPECT_EQ(stream.width, 16U);
    EXPECT_EQ(stream.height, 12U);
    EXPECT_EQ(stream.fps, 30U);
    EXPECT_DOUBLE_EQ(stream.horizontal_fov_rad, 1.0226);
    EXPECT_DOUBLE_EQ(stream.vertical_fov_rad, 0.7966);
    EXPECT_EQ(stream.unit_m, 1e-3F);
    EXPECT_FALSE(stream.mirrored);
  }
  source.pixel_format = 101;
  source.mirrored = true;
  source.with_fov = false;
  const TestFile file(source.bytes());
  const DepthStream stream = Reader(file.path()).stream();
  EXPECT_EQ(stream.unit_m, 1e-4F);
  EXPECT_TRUE(stream.mirrored);
  EXPECT_EQ(stream.horizontal_fov_rad, 0);
}

TEST(OniReader, TellsWhereACroppedImageWasInTheSensors) {
  OniFile source;
  source.cropping = {4, 2, 8, 6};
  source.frames = {test::example_image(8, 6, 1)};
  const TestFile file(source.bytes());
  Reader reader(file.path());
  EXPECT_EQ(reader.stream().width, 8U);
  EXPECT_EQ(reader.stream().height, 6U);
  EXPECT_EQ(reader.stream().sensor_width, 16U);
  EXPECT_EQ(reader.stream().cropping.x, 4U);
  DepthFrame frame;
  ASSERT_EQ(reader.read(0, frame), std::nullopt);
  EXPECT_EQ(frame.depth, source.frames[0]);
}

TEST(OniReader, PlaysARecordingWhoseRecorderWasKilled) {
  OniFile source = readable_file();
  source.with_end = false;
  const TestFile file(source.bytes());
  const Reader reader(file.path());
  EXPECT_EQ(reader.size(), 5U);
  EXPECT_NE(reader.damage().find("cut off"), std::string::npos) << reader.damage();
}

TEST(OniReader, GivesAllWholeFramesOfAFileThatIsCutShort) {
  const OniFile source = readable_file();
  std::vector<std::size_t> starts;
  const std::string content = source.bytes(&starts);
  const std::string cut = content.substr(0, starts[3] + 50);
  EXPECT_EQ(intact(source, cut), (std::vector<std::uint32_t>{1, 2, 3}));
  const TestFile file(cut);
  EXPECT_NE(Reader(file.path()).damage().find("cut off; whole frames in it: 3"), std::string::npos);
}

TEST(OniReader, LosesOnlyTheFrameWhoseRecordIsDamaged) {
  const OniFile source = readable_file();
  std::vector<std::size_t> starts;
  const std::string whole = source.bytes(&starts);
  for (const std::size_t byte : {0U, 2U, 5U, 13U, 18U}) {  // magic, type, sizes of the third frame
    for (const char value : {'\x7f', '\x01'}) {
      std::string content = whole;
      if (content[starts[2] + byte] == value) continue;
      content[starts[2] + byte] = value;
      const auto frames = intact(source, content);
      const TestFile file(content);
      EXPECT_NE(Reader(file.path()).damage(), "") << byte;
      EXPECT_EQ(frames, (std::vector<std::uint32_t>{1, 2, 4, 5})) << byte << " " << int(value);
    }
  }
}

TEST(OniReader, SaysWhichFrameIsDamaged) {
  const OniFile source = readable_file();
  std::vector<std::size_t> starts;
  std::string content = source.bytes(&starts);
  content[starts[1] + 28 + 12] = '\xff';  // more entries in the table than bytes in the frame
  content[starts[1] + 28 + 13] = '\xff';
  const TestFile file(content);
  Reader reader(file.path());
  DepthFrame frame;
  EXPECT_EQ(reader.read(0, frame), std::nullopt);
  const auto why = reader.read(1, frame);
  ASSERT_TRUE(why);
  EXPECT_NE(why->find("frame 2 of 5"), std::string::npos) << *why;
}

TEST(OniReader, RefusesWhatIsNoDepthRecordingAndSaysWhy) {
  EXPECT_NE(refusal("").find("not an .oni file"), std::string::npos);
  EXPECT_NE(refusal("NI10").find("ends in its header"), std::string::npos);
  EXPECT_NE(refusal(std::string(1000, 'x')).find("not an .oni file"), std::string::npos);
  EXPECT_NE(refusal(readable_file().bytes().substr(0, 24)).find("no depth stream"),
            std::string::npos);
  OniFile colour = readable_file();
  colour.depth_node_type = 3;
  EXPECT_NE(refusal(colour.bytes()).find("no depth stream"), std::string::npos);
  OniFile jpeg = readable_file();
  jpeg.codec = "JPEG";
  EXPECT_NE(refusal(jpeg.bytes()).find("'JPEG'"), std::string::npos);
  OniFile shift = readable_file();
  shift.pixel_format = 102;
  EXPECT_NE(refusal(shift.bytes()).find("pixel format 102"), std::string::npos);
  OniFile huge = readable_file();
  huge.width = 1'000'000;
  EXPECT_NE(refusal(huge.bytes()).find("1000000 x 12"), std::string::npos);
}

TEST(OniReader, SaysWhichFileCannotBeOpened) {
  for (const char* const path : {"/no/such/file.oni", "/tmp"}) {
    try {
      const Reader reader(path);
      FAIL() << path;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find(path), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace cleave::oni
