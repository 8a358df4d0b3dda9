// SPDX-License-Identifier: BSD-3-Clause
// Recordings with the real processes: what is replayed equals what was recorded.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <type_traits>

#include "recording/frames/frame_reader.hpp"
#include "tests/integration/support/daemons.hpp"
#include "tests/integration/support/roudi_fixture.hpp"

namespace cleave::test {
namespace {

using recording::Frame;
using recording::Kind;

// Everything but when it was published and recorded.
struct Recorded {
  std::vector<recording::Cloud> clouds;
  std::vector<recording::Labels> labels;
  std::vector<recording::SegmentList> lists;
};

template <class Content>
void add(std::vector<Content>& to, Frame& frame) {
  auto content = std::get<Content>(std::move(frame.content));
  content.header.arrival_time_ns = 0;
  content.header.publication_time_ns = 0;
  if constexpr (!std::is_same_v<Content, recording::Cloud>) content.cloud_publication_time_ns = 0;
  if constexpr (std::is_same_v<Content, recording::SegmentList>) {
    content.cloud_reception_time_ns = 0;
  }
  to.push_back(std::move(content));
}

Recorded read(const std::filesystem::path& file) {
  recording::FrameReader reader(file);
  Recorded recorded;
  while (auto frame = reader.next()) {
    if (frame->kind() == Kind::cloud) add(recorded.clouds, *frame);
    if (frame->kind() == Kind::labels) add(recorded.labels, *frame);
    if (frame->kind() == Kind::segments) add(recorded.lists, *frame);
  }
  EXPECT_TRUE(reader.mcap().contents().closed) << file;
  EXPECT_TRUE(reader.problems().empty()) << file;
  return recorded;
}

// The bytes: NaN is as good as NaN.
bool same(const recording::Cloud& a, const recording::Cloud& b) {
  return a.header == b.header && a.xyz.size() == b.xyz.size() &&
         std::memcmp(a.xyz.data(), b.xyz.data(), a.xyz.size() * sizeof(float)) == 0;
}

class Recording : public testing::Test {
 protected:
  Process record(const std::string& name, std::vector<std::string> options = {}) {
    options.insert(options.begin(), {"record", "--sensor", "camera"});
    options.push_back((folder_.path() / name).string());
    Process recorder = daemons_.run("cleave", options);
    EXPECT_TRUE(recorder.logs("recording sensor")) << recorder.log();
    return recorder;
  }
  std::string file(const std::string& name) const { return (folder_.path() / name).string(); }

  const RouDi roudi_;
  const Daemons daemons_{23, true};
  const TemporaryFolder folder_;
};

TEST_F(Recording, ReplayedAndRecordedAgainHoldsEqualMessages) {
  constexpr std::size_t frames = 300;
  Process segmenter = daemons_.segmenter({"--lossless"});
  ASSERT_TRUE(segmenter.logs("ready")) << segmenter.log();
  Process recorder = record("first.mcap");
  Process grabber =
      daemons_.grabber("synthetic:medium", {"--lossless", "--frames", std::to_string(frames)});
  ASSERT_EQ(grabber.wait(std::chrono::minutes(5)), 0) << grabber.log();
  ASSERT_EQ(recorder.wait(), 0) << recorder.log();
  segmenter.signal(SIGTERM);
  (void)segmenter.wait();
  const Recorded first = read(file("first.mcap"));
  ASSERT_EQ(first.clouds.size(), frames);
  ASSERT_EQ(first.labels.size(), frames);
  ASSERT_EQ(first.lists.size(), frames);

  Process again = record("second.mcap");
  Process replay = daemons_.run("cleave", {"replay", file("first.mcap")});
  EXPECT_EQ(replay.wait(std::chrono::minutes(5)), 0) << replay.log();
  ASSERT_EQ(again.wait(), 0) << again.log();
  const Recorded second = read(file("second.mcap"));
  EXPECT_TRUE(std::ranges::equal(first.clouds, second.clouds, same));
  EXPECT_TRUE(first.labels == second.labels);
  EXPECT_TRUE(first.lists == second.lists);
}

TEST_F(Recording, OfRealScenesHasTheSameLabelsAfterALosslessReplay) {
  const std::string scenes = learn_scenes();
  if (scenes.empty()) GTEST_SKIP() << no_scenes;
  Process segmenter = daemons_.segmenter({"--lossless"});
  ASSERT_TRUE(segmenter.logs("ready")) << segmenter.log();
  Process recorder = record("first.mcap");
  Process grabber = daemons_.grabber("pcd:" + scenes, {"--lossless"});
  ASSERT_EQ(grabber.wait(std::chrono::minutes(5)), 0) << grabber.log();
  ASSERT_EQ(recorder.wait(), 0) << recorder.log();
  Process again = record("second.mcap");
  Process replay =
      daemons_.run("cleave", {"replay", "--lossless", "--as-fast-as-possible", file("first.mcap")});
  EXPECT_EQ(replay.wait(std::chrono::minutes(5)), 0) << replay.log();
  ASSERT_EQ(again.wait(), 0) << again.log();
  Process from_source = record("third.mcap");
  Process player = daemons_.grabber("mcap:" + file("first.mcap"), {"--lossless"});
  ASSERT_EQ(player.wait(std::chrono::minutes(5)), 0) << player.log();
  ASSERT_EQ(from_source.wait(), 0) << from_source.log();

  const Recorded first = read(file("first.mcap"));
  const Recorded second = read(file("second.mcap"));
  const Recorded third = read(file("third.mcap"));
  ASSERT_EQ(first.labels.size(), 45U);
  EXPECT_TRUE(first.labels == second.labels);
  ASSERT_EQ(third.labels.size(), 45U);
  for (std::size_t i = 0; i < third.labels.size(); ++i) {
    EXPECT_TRUE(first.labels[i].label == third.labels[i].label) << i;
  }
  constexpr std::uintmax_t most_bytes_a_frame = 100'000;  // with labels and segments
  EXPECT_LE(std::filesystem::file_size(file("first.mcap")), 45 * most_bytes_a_frame);
}

TEST_F(Recording, IsCompleteAfterASignalAndRecoveredAfterAKill) {
  Process camera = daemons_.grabber("synthetic:medium");
  Process asked = record("asked.mcap", {"--topics", "cloud"});
  Process killed = record("killed.mcap", {"--topics", "cloud"});
  const auto has_frames = [&](const std::string& name) {
    return eventually([&] { return std::filesystem::file_size(file(name)) > 1'000'000; });
  };
  ASSERT_TRUE(has_frames("asked.mcap")) << asked.log() << camera.log();
  ASSERT_TRUE(has_frames("killed.mcap")) << killed.log();
  asked.signal(SIGINT);
  EXPECT_EQ(asked.wait(), 0) << asked.log();
  EXPECT_FALSE(read(file("asked.mcap")).clouds.empty());
  killed.signal(SIGKILL);
  (void)killed.wait();
  Process recover = daemons_.run("cleave", {"recover", file("killed.mcap"), file("whole.mcap")});
  EXPECT_EQ(recover.wait(), 0) << recover.log();
  const Recorded whole = read(file("whole.mcap"));
  ASSERT_FALSE(whole.clouds.empty());
  for (std::size_t i = 1; i < whole.clouds.size(); ++i) {
    EXPECT_GT(whole.clouds[i].header.frame_id, whole.clouds[i - 1].header.frame_id);
  }
}

TEST_F(Recording, RefusesToReplayResultsBesideALiveSegmenter) {
  Process segmenter = daemons_.segmenter();
  ASSERT_TRUE(segmenter.logs("ready")) << segmenter.log();
  Process recorder = record("a.mcap");
  Process grabber = daemons_.grabber("synthetic:medium", {"--frames", "3"});
  ASSERT_EQ(recorder.wait(), 0) << recorder.log();
  Process replay = daemons_.run("cleave", {"replay", file("a.mcap")});
  EXPECT_EQ(replay.wait(), 1);
  EXPECT_NE(replay.log().find("--topics cloud"), std::string::npos) << replay.log();
}

}  // namespace
}  // namespace cleave::test
