// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "recording/frames/contract_check.hpp"
#include "recording/frames/frame_reader.hpp"
#include "recording/frames/frame_writer.hpp"
#include "recording/frames/read_ahead.hpp"
#include "recording/frames/segment_list_message.hpp"
#include "recording/mcap/writer.hpp"
#include "recording/schemas/schemas.hpp"
#include "tests/unit/recording/recording_files.hpp"

namespace cleave::recording {
namespace {

class FrameFile : public testing::Test {
 protected:
  Frame through_file(const Frame& frame) const {
    std::filesystem::remove(file_);
    FrameWriter writer(file_);
    writer.write(frame);
    writer.close();
    return read_frames(file_).at(0);
  }
  // The cloud as it comes back.
  Cloud through_file(const Cloud& cloud) const {
    return std::get<Cloud>(through_file(Frame{5, cloud}).content);
  }
  TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_.path() / "a.mcap";
};

TEST_F(FrameFile, GivesBackADepthCloudBitForBit) {
  const Cloud cloud = depth_cloud(4);
  const Cloud back = through_file(cloud);
  EXPECT_EQ(back.header, cloud.header);
  EXPECT_TRUE(same_points(back.xyz, cloud.xyz));
}

TEST_F(FrameFile, GivesBackAnUnorganisedCloudBitForBit) {
  const Cloud cloud = free_cloud(4);
  const Cloud back = through_file(cloud);
  EXPECT_EQ(back.header, cloud.header);
  EXPECT_TRUE(same_points(back.xyz, cloud.xyz));
}

TEST_F(FrameFile, GivesBackAFullSizeCloud) {
  const Cloud cloud = depth_cloud(1, 640, 480);
  EXPECT_TRUE(same_points(through_file(cloud).xyz, cloud.xyz));
}

TEST_F(FrameFile, GivesBackLabelsAndSegments) {
  const Frame map = through_file(Frame{6, labels(4)});
  EXPECT_EQ(map.log_time_ns, 6);
  EXPECT_EQ(std::get<Labels>(map.content), labels(4));
  const Frame list = through_file(Frame{7, segment_list(4)});
  EXPECT_EQ(std::get<SegmentList>(list.content), segment_list(4));
}

TEST_F(FrameFile, RefusesFramesOfNoSize) {
  FrameWriter writer(file_);
  EXPECT_THROW(writer.write({0, Cloud{header(1, 0, 0), {}}}), DataError);
  EXPECT_THROW(writer.write({0, Cloud{header(1, 1601, 1200), {}}}), DataError);
  Labels half = labels(1);
  half.label.pop_back();
  EXPECT_THROW(writer.write({0, half}), DataError);
}

TEST_F(FrameFile, KeepsTheOrderAndTheKindsThatAreAskedFor) {
  write_frames(file_, 5, 4096);
  EXPECT_EQ(read_frames(file_).size(), 15U);
  FrameReader reader(file_, {{Kind::labels}, "", 0, {}});
  for (std::uint64_t id = 1; id <= 5; ++id) {
    const auto frame = reader.next();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->kind(), Kind::labels);
    EXPECT_EQ(frame->header().frame_id, id);
  }
  EXPECT_FALSE(reader.next());
}

TEST_F(FrameFile, StartsAndEndsWhereItIsTold) {
  write_frames(file_, 30, 4096);
  FrameReader reader(file_, {{Kind::cloud}, "", 0.1, 0.2});
  std::vector<std::uint64_t> ids;
  while (const auto frame = reader.next()) ids.push_back(frame->header().frame_id);
  EXPECT_EQ(ids, (std::vector<std::uint64_t>{5, 6, 7}));
}

TEST_F(FrameFile, HoldsOnlyTheSensorThatIsAskedFor) {
  FrameWriter writer(file_);
  Cloud other = depth_cloud(1);
  other.header.sensor = "other";
  writer.write({1, depth_cloud(1)});
  writer.write({2, other});
  writer.close();
  FrameReader reader(file_, {{Kind::cloud}, "other", 0, {}});
  const auto frame = reader.next();
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->header().sensor, "other");
  EXPECT_FALSE(reader.next());
}

TEST_F(FrameFile, OfAnotherContractIsNotMisread) {
  EXPECT_TRUE(is_of_this_contract(contract_schema));
  EXPECT_TRUE(is_of_this_contract(recording_schema));
  EXPECT_TRUE(is_of_this_contract("// another comment\n" + recording_schema));
  std::string other = contract_schema;
  const std::string field = "unsigned long epoch;";
  other.replace(other.find(field), field.size(), "unsigned long long epoch;");
  EXPECT_FALSE(is_of_this_contract(other));
  EXPECT_FALSE(is_of_this_contract(""));

  McapWriter writer(file_);
  const auto schema = writer.add_schema("cleave::v1::SegmentList", "omgidl", other);
  writer.write(writer.add_channel(schema, "cleave/camera/segments", "cdr"), 1, {1, 1},
               segment_list_message(segment_list(1)));
  writer.close();
  FrameReader reader(file_);
  EXPECT_FALSE(reader.next());
  ASSERT_EQ(reader.problems().size(), 1U);
  EXPECT_NE(reader.problems()[0].find("another version of the contract"), std::string::npos);
}

TEST_F(FrameFile, BeginsAgainWhenItLoops) {
  write_frames(file_, 2, 4096);
  ReadAhead ahead(file_, {{Kind::cloud}, "", 0, {}}, true);
  for (std::uint64_t i = 0; i < 6; ++i) {
    AheadFrame frame;
    ASSERT_EQ(ahead.next(std::chrono::seconds(20), frame), ReadAhead::Result::item);
    EXPECT_EQ(frame.pass, i / 2);
    EXPECT_EQ(frame.frame.header().frame_id, i % 2 + 1);
  }
}

TEST_F(FrameFile, EndsWhenItDoesNotLoop) {
  write_frames(file_, 1, 4096);
  ReadAhead ahead(file_, {{Kind::cloud}, "", 0, {}}, false);
  AheadFrame frame;
  EXPECT_EQ(ahead.next(std::chrono::seconds(20), frame), ReadAhead::Result::item);
  EXPECT_EQ(ahead.next(std::chrono::seconds(20), frame), ReadAhead::Result::end);
}

}  // namespace
}  // namespace cleave::recording
