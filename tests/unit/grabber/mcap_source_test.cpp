// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/sources/mcap_source.hpp"

#include <gtest/gtest.h>

#include "recording/frames/frame_writer.hpp"
#include "tests/unit/recording/recording_files.hpp"
#include "tests/unit/recording/ros/ros_bytes.hpp"

namespace cleave::sensor {
namespace {

using std::chrono::seconds;

class McapSourceFile : public testing::Test {
 protected:
  void write(std::uint64_t count) const { recording::write_frames(file_, count, 4096); }
  recording::TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_.path() / "a.mcap";
};

TEST_F(McapSourceFile, PlaysEveryCloudBitForBitWithItsTimes) {
  write(5);
  McapSource source(file_, false);
  ASSERT_FALSE(source.open());
  EXPECT_FALSE(source.realtime());
  std::vector<float> xyz(32 * 24 * 3);
  for (std::uint64_t id = 1; id <= 5; ++id) {
    Frame frame;
    ASSERT_EQ(source.next(seconds(20), frame), Poll::frame);
    source.write_points(xyz.data());
    const recording::Cloud expected = recording::depth_cloud(id);
    EXPECT_TRUE(recording::same_points(xyz, expected.xyz));
    EXPECT_EQ(frame.capture_time_ns, expected.header.capture_time_ns);
    EXPECT_EQ(frame.device_time_us, expected.header.device_time_us);
    EXPECT_EQ(frame.intrinsics.fx, expected.header.fx);
    EXPECT_FALSE(frame.begins_epoch);
    EXPECT_EQ(frame.until_next.has_value(), id < 5);
    if (id < 5) {
      EXPECT_EQ(frame.until_next.value().count(), 33'333'333);
    }
  }
  Frame frame;
  EXPECT_EQ(source.next(seconds(20), frame), Poll::end);
}

TEST_F(McapSourceFile, BeginsAnEpochWithEachPassOfALoop) {
  write(2);
  McapSource source(file_, true);
  ASSERT_FALSE(source.open());
  for (int i = 0; i < 6; ++i) {
    Frame frame;
    ASSERT_EQ(source.next(seconds(20), frame), Poll::frame);
    EXPECT_EQ(frame.begins_epoch, i > 0 && i % 2 == 0) << i;
  }
}

TEST_F(McapSourceFile, PlaysOnAfterTheLongestGapWhenTheRecordingsClockJumps) {
  constexpr std::int64_t s_ns = 1'000'000'000;
  constexpr std::int64_t day_ns = 86'400 * s_ns;
  recording::FrameWriter writer(file_);
  std::uint64_t id = 0;
  for (const std::int64_t time_ns : {s_ns, 3 * s_ns, 3 * s_ns + 11 * day_ns}) {
    writer.write({time_ns, recording::depth_cloud(++id)});
  }
  writer.close();
  McapSource source(file_, false, "", recording::GapLimit(5));
  ASSERT_FALSE(source.open());
  Frame frame;
  ASSERT_EQ(source.next(seconds(20), frame), Poll::frame);
  EXPECT_EQ(frame.until_next, seconds(2)) << "a pause that is shorter is kept";
  ASSERT_EQ(source.next(seconds(20), frame), Poll::frame);
  EXPECT_EQ(frame.until_next, seconds(5));
  ASSERT_EQ(source.next(seconds(20), frame), Poll::frame);
  EXPECT_EQ(source.next(seconds(20), frame), Poll::end);
}

TEST_F(McapSourceFile, PlaysByLogTimeWhatWasWrittenInAnotherOrder) {
  recording::FrameWriter writer(file_, 4096);
  for (const std::uint64_t id : {3, 1, 2}) {
    writer.write({static_cast<std::int64_t>(id) * 1'000'000, recording::depth_cloud(id)});
  }
  writer.close();
  McapSource source(file_, false);
  ASSERT_FALSE(source.open());
  for (std::uint64_t id = 1; id <= 3; ++id) {
    Frame frame;
    ASSERT_EQ(source.next(seconds(20), frame), Poll::frame);
    EXPECT_EQ(frame.capture_time_ns, recording::depth_cloud(id).header.capture_time_ns);
  }
}

TEST_F(McapSourceFile, SaysWhyNothingCanBePlayed) {
  EXPECT_TRUE(McapSource(file_, false).open());
  recording::FrameWriter writer(file_);
  writer.write({1, recording::labels(1)});
  writer.close();
  const Failure failure = McapSource(file_, false).open();
  ASSERT_TRUE(failure);
  EXPECT_NE(failure->find("holds no cloud"), std::string::npos) << *failure;
}

TEST_F(McapSourceFile, PlaysWhatIsIntactAndCountsTheRest) {
  write(12);
  // A chunk for each cloud, label map and segment list: that of the second cloud.
  const recording::ChunkPlace chunk = recording::McapReader(file_).contents().chunks.at(3);
  recording::Bytes bytes = recording::read_all(file_);
  bytes[chunk.offset + chunk.length - 1] ^= std::byte{1};
  recording::write_all(file_, bytes);
  McapSource source(file_, false);
  ASSERT_FALSE(source.open());
  int frames = 0;
  Frame frame;
  while (source.next(seconds(20), frame) == Poll::frame) ++frames;
  EXPECT_EQ(frames, 11);
  EXPECT_EQ(source.counts().unusable.at("damaged"), 1U);
}

TEST_F(McapSourceFile, PlaysATopicOfABagOfRosAndCountsWhatItCannotByCause) {
  using namespace recording::ros;
  const recording::Cloud cloud = recording::depth_cloud(1);
  CloudSpec empty;
  empty.width = 0;
  Bag(file_)
      .add("/points", cloud_type, 1, bytes_of_cloud(empty))
      .add("/points", cloud_type, 2, bytes_of_cloud(cloud_of(cloud.xyz, 32, 24)))
      .add("/points", cloud_type, 3,
           bytes_of_cloud(cloud_of(std::vector<float>(3 * 1601 * 1200), 1601, 1200)))
      .add("/points", cloud_type, 9, bytes_of_cloud(cloud_of(cloud.xyz, 32, 24)))
      .close();
  McapSource source(file_, false, "/points");
  ASSERT_FALSE(source.open());
  std::vector<float> xyz(32 * 24 * 3);
  Frame frame;
  ASSERT_EQ(source.next(seconds(20), frame), Poll::frame);
  source.write_points(xyz.data());
  EXPECT_TRUE(recording::same_points(xyz, cloud.xyz));
  EXPECT_EQ(frame.until_next.value().count(), 7);
  ASSERT_EQ(source.next(seconds(20), frame), Poll::frame);
  EXPECT_EQ(source.next(seconds(20), frame), Poll::end);
  EXPECT_EQ(source.counts().unusable,
            (std::map<std::string, std::uint64_t>{{"no points", 1}, {"too many points", 1}}));
  const Failure failure = McapSource(file_, false, "/elsewhere").open();
  ASSERT_TRUE(failure);
  EXPECT_NE(failure->find("has no topic '/elsewhere'"), std::string::npos) << *failure;
}

}  // namespace
}  // namespace cleave::sensor
