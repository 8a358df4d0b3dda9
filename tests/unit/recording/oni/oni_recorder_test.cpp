// SPDX-License-Identifier: BSD-3-Clause
// What OpenNI2's own recorder wrote, from the synthetic camera.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fstream>
#include <thread>

#include "recording/oni/oni_reader.hpp"
#include "sensor/sources/oni_source.hpp"
#include "tests/integration/support/process.hpp"

namespace cleave::oni {
namespace {

using cleave::test::Process;
using cleave::test::TemporaryFolder;

constexpr std::size_t pixels = std::size_t{640} * 480;

// Slow enough that the recording process reads every frame on a busy machine, too.
constexpr char camera[] = "synthetic:simple?frames=3&fps=8";

struct InputFrame {
  std::uint64_t timestamp_us = 0;
  std::vector<std::uint16_t> depth;
};

class OniRecorder : public testing::Test {
 protected:
  [[nodiscard]] Process record(int frames) const {
    return Process({cleave::test::program("oni_recorder"), camera, file().string(), raw().string(),
                    std::to_string(frames)});
  }
  [[nodiscard]] std::filesystem::path file() const { return folder_.path() / "camera.oni"; }
  [[nodiscard]] std::filesystem::path raw() const { return folder_.path() / "camera.raw"; }

  [[nodiscard]] std::vector<InputFrame> inputs() const {
    std::ifstream stream(raw(), std::ios::binary);
    std::vector<InputFrame> frames;
    InputFrame frame;
    frame.depth.resize(pixels);
    while (stream.read(reinterpret_cast<char*>(&frame.timestamp_us), sizeof frame.timestamp_us) &&
           stream.read(reinterpret_cast<char*>(frame.depth.data()), 2 * pixels)) {
      frames.push_back(frame);
    }
    return frames;
  }

  TemporaryFolder folder_;
};

// Every frame that both have is equal in pixels; how many there are. The recorder's time begins
// with its first frame, which is one of the first inputs.
std::size_t count_equal(Reader& reader, const std::vector<InputFrame>& inputs) {
  DepthFrame frame;
  std::size_t equal = 0;
  for (std::size_t first = 0; first < inputs.size() && equal == 0; ++first) {
    for (std::size_t i = 0; i < reader.size(); ++i) {
      EXPECT_EQ(reader.read(i, frame), std::nullopt);
      for (const InputFrame& input : inputs) {
        if (input.timestamp_us != inputs[first].timestamp_us + frame.timestamp_us) continue;
        if (input.depth != frame.depth) return 0;
        ++equal;
      }
    }
  }
  return equal;
}

TEST_F(OniRecorder, ARecordingByOpenNi2GivesBackWhatWasRecordedPixelForPixel) {
  Process recorder = record(8);
  ASSERT_EQ(recorder.wait(), 0) << recorder.log();
  const std::vector<InputFrame> frames = inputs();
  ASSERT_EQ(frames.size(), 8U);
  Reader reader(file());
  EXPECT_EQ(reader.damage(), "");
  EXPECT_GE(reader.size(), 7U);
  EXPECT_GE(count_equal(reader, frames), 7U);
  EXPECT_NEAR(reader.stream().horizontal_fov_rad, 1.0947, 1e-3);
}

TEST_F(OniRecorder, ARecordingWhoseRecorderWasKilledPlays) {
  Process recorder = record(0);
  ASSERT_TRUE(cleave::test::eventually([this] { return inputs().size() >= 5; })) << recorder.log();
  recorder.signal(SIGKILL);
  EXPECT_EQ(recorder.wait(), 128 + SIGKILL);
  Reader reader(file());
  EXPECT_NE(reader.damage(), "");
  EXPECT_GE(count_equal(reader, inputs()), 3U);
}

// Burns the processors for as long as it lives.
class Load {
 public:
  Load() {
    for (auto& thread : threads_) {
      thread = std::jthread([](const std::stop_token& stopped) {
        std::atomic<std::uint64_t> work = 0;
        while (!stopped.stop_requested()) ++work;
      });
    }
  }

 private:
  std::array<std::jthread, 4> threads_;
};

TEST_F(OniRecorder, PlaysTwoHundredTimesInARowUnderLoadPixelForPixel) {
  Process recorder = record(4);
  ASSERT_EQ(recorder.wait(), 0) << recorder.log();
  std::vector<std::vector<float>> expected;
  Reader reader(file());
  ASSERT_GE(count_equal(reader, inputs()), 3U);
  const Load load;
  for (int round = 0; round < 200; ++round) {
    sensor::OniSource source(file(), false);
    ASSERT_EQ(source.open(), std::nullopt);
    sensor::Frame frame;
    std::vector<float> xyz(3 * pixels);
    std::size_t count = 0;
    for (; source.next({}, frame) == sensor::Poll::frame; ++count) {
      source.write_points(xyz.data());
      if (round == 0) {
        expected.push_back(xyz);
        DepthFrame depth;
        ASSERT_EQ(reader.read(count, depth), std::nullopt);
        for (std::size_t p = 0; p < pixels; ++p) {
          const float z = xyz[3 * p + 2];
          ASSERT_EQ(std::isnan(z) ? 0 : std::lround(z * 1000), depth.depth[p]);
        }
      }
      ASSERT_EQ(std::memcmp(xyz.data(), expected.at(count).data(), xyz.size() * sizeof(float)), 0);
    }
    ASSERT_EQ(count, reader.size());
  }
}

}  // namespace
}  // namespace cleave::oni
