// SPDX-License-Identifier: BSD-3-Clause
// Cameras of more than 640 x 480 points, from the grabber to a recording and back.
#include <gtest/gtest.h>
#include <sys/statvfs.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <ostream>
#include <string>

#include "recording/frames/frame_reader.hpp"
#include "tests/integration/support/daemons.hpp"
#include "tests/integration/support/roudi_fixture.hpp"

namespace cleave::test {
namespace {

constexpr std::chrono::minutes patience(5);
constexpr std::uint64_t memory_of_large_pools = 850'000'000;

std::string pools(const std::string& name) {
  return std::string(CLEAVE_SOURCE_DIR) + "/config/" + name;
}

bool shared_memory_has_room() {
  struct statvfs room {};
  return ::statvfs("/dev/shm", &room) == 0 &&
         std::uint64_t{room.f_bavail} * room.f_frsize > memory_of_large_pools;
}

struct Size {
  std::uint32_t width, height;
  friend std::ostream& operator<<(std::ostream& out, const Size& size) {
    return out << size.text();
  }
  [[nodiscard]] std::string text() const {
    return std::to_string(width) + "x" + std::to_string(height);
  }
};

class LargeCamera : public testing::TestWithParam<Size> {
 protected:
  void SetUp() override {
    if (!shared_memory_has_room()) GTEST_SKIP() << "/dev/shm has no room for roudi-large.toml";
  }
  [[nodiscard]] Process record(const std::string& name) const {
    Process recorder = daemons_.run("cleave", {"record", "--sensor", "camera", file(name)});
    EXPECT_TRUE(recorder.logs("recording sensor")) << recorder.log();
    return recorder;
  }
  [[nodiscard]] std::string file(const std::string& name) const {
    return (folder_.path() / name).string();
  }
  // Frames of the camera's size, by kind.
  [[nodiscard]] std::array<int, 3> frames_of(const std::string& name) const {
    recording::FrameReader reader(file(name));
    std::array<int, 3> count{};
    while (const auto frame = reader.next()) {
      EXPECT_EQ(frame->header().width, GetParam().width);
      EXPECT_EQ(frame->header().height, GetParam().height);
      ++count.at(static_cast<std::size_t>(frame->kind()));
    }
    return count;
  }

  const TemporaryFolder folder_;
  const Daemons daemons_{35, true};
};

// Slowly: a recorder that gets no processor for a while loses what its readers' histories have no
// room for, and that is not this test's subject.
TEST_P(LargeCamera, IsGrabbedStreamedRecordedReplayedAndVerified) {
  constexpr std::array<int, 3> all = {12, 12, 12};
  const RouDi roudi(pools("roudi-large.toml"));
  Process segmenter = daemons_.segmenter({"--lossless"});
  ASSERT_TRUE(segmenter.logs("ready")) << segmenter.log();
  Process recorder = record("first.mcap");
  Process grabber = daemons_.grabber("synthetic:medium", {"--size", GetParam().text(), "--fps", "5",
                                                          "--lossless", "--frames", "12"});
  ASSERT_EQ(grabber.wait(patience), 0) << grabber.log();
  ASSERT_EQ(recorder.wait(), 0) << recorder.log();
  EXPECT_EQ(frames_of("first.mcap"), all) << recorder.log() << segmenter.log() << grabber.log();

  Process again = record("second.mcap");
  Process replay = daemons_.run("cleave", {"replay", "--lossless", file("first.mcap")});
  EXPECT_EQ(replay.wait(patience), 0) << replay.log();
  ASSERT_EQ(again.wait(), 0) << again.log();
  EXPECT_EQ(frames_of("second.mcap"), all) << replay.log() << again.log();

  Process verify = daemons_.run(
      "cleave", {"verify", file("second.mcap"), "--expect", file("first.mcap"), "--json"});
  EXPECT_EQ(verify.wait(patience), 0) << verify.log() << verify.output();
}

INSTANTIATE_TEST_SUITE_P(Sizes, LargeCamera, testing::Values(Size{848, 480}, Size{1280, 720}),
                         [](const auto& size) { return size.param.text(); });

TEST(LargeCameraWithoutLargePools, IsToldWhichPoolsItNeedsAndNothingDies) {
  const RouDi roudi;
  const Daemons daemons(35, true);
  Process segmenter = daemons.segmenter();
  ASSERT_TRUE(segmenter.logs("ready")) << segmenter.log();
  Process grabber = daemons.grabber("synthetic:medium", {"--size", "848x480"});
  EXPECT_TRUE(grabber.logs("roudi-large.toml")) << grabber.log();
  grabber.signal(SIGTERM);
  EXPECT_EQ(grabber.wait(), 0) << grabber.log();
  segmenter.signal(SIGTERM);
  EXPECT_EQ(segmenter.wait(), 0) << segmenter.log();
}

}  // namespace
}  // namespace cleave::test
