// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/record/background_writer.hpp"

#include <gtest/gtest.h>

#include "recording/error.hpp"
#include "recording/frames/frame_reader.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/recording/recording_files.hpp"

namespace cleave::client {
namespace {

using recording::Kind;

class Recorder : public testing::Test {
 protected:
  [[nodiscard]] recording::Texts metadata() const {
    const recording::McapReader reader(file_);
    return reader.contents().metadata.at(0).entries;
  }
  tests::TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_.path() / "a.mcap";
};

TEST_F(Recorder, WritesWhatItIsOfferedAndItsCounts) {
  {
    BackgroundWriter writer(file_);
    for (std::uint64_t id = 1; id <= 10; ++id) {
      EXPECT_TRUE(writer.offer({1, recording::depth_cloud(id)}));
    }
    EXPECT_TRUE(writer.offer({1, recording::labels(1)}));
    writer.finish({{"sensor", "camera"}});
    EXPECT_EQ(writer.state().written.at(Kind::cloud), 10U);
  }
  EXPECT_EQ(recording::read_frames(file_).size(), 11U);
  EXPECT_EQ(metadata().at("written cloud"), "10");
  EXPECT_EQ(metadata().at("written labels"), "1");
  EXPECT_EQ(metadata().at("dropped cloud"), "0");
  EXPECT_EQ(metadata().at("sensor"), "camera");
}

TEST_F(Recorder, DropsWholeFramesAndCountsThemWhereTheQueueIsFull) {
  RecordingLimits limits;
  limits.queue_bytes = 100;  // less than one frame: a disk that never gets anything done
  {
    BackgroundWriter writer(file_, limits);
    EXPECT_FALSE(writer.offer({1, recording::depth_cloud(1)}));
    EXPECT_FALSE(writer.offer({1, recording::depth_cloud(2)}));
    EXPECT_FALSE(writer.offer({1, recording::labels(2)}));
    writer.finish({});
    EXPECT_EQ(writer.state().dropped.at(Kind::cloud), 2U);
  }
  EXPECT_TRUE(recording::read_frames(file_).empty());
  EXPECT_EQ(metadata().at("dropped cloud"), "2");
  EXPECT_EQ(metadata().at("dropped labels"), "1");
}

TEST_F(Recorder, StopsAtTheSizeThatWasAskedFor) {
  RecordingLimits limits;
  limits.max_file_bytes = 1;
  BackgroundWriter writer(file_, limits);
  EXPECT_TRUE(writer.offer({1, recording::depth_cloud(1)}));
  writer.finish({});
  EXPECT_FALSE(writer.state().failed);
  EXPECT_NE(writer.state().stopped.find("size"), std::string::npos);
  EXPECT_EQ(recording::read_frames(file_).size(), 1U);
}

TEST_F(Recorder, RefusesADiskWithoutRoom) {
  RecordingLimits limits;
  limits.reserve_bytes = ~std::uint64_t{0};
  EXPECT_THROW(BackgroundWriter writer(file_, limits), recording::FileError);
  EXPECT_FALSE(std::filesystem::exists(file_));
}

TEST_F(Recorder, HasWrittenASecondAgoWhatItWasOfferedThen) {
  BackgroundWriter writer(file_);
  EXPECT_TRUE(writer.offer({1, recording::depth_cloud(1)}));
  std::size_t found = 0;
  for (int i = 0; i < 600 && found == 0; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    const recording::McapReader reader(file_);
    found = reader.contents().chunks.size();
  }
  EXPECT_EQ(found, 1U) << "the open chunk was never flushed";
}

}  // namespace
}  // namespace cleave::client
