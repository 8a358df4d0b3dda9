// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>

#include "cleave/commands/convert_command.hpp"
#include "recording/frames/frame_writer.hpp"
#include "recording/mcap/reader.hpp"
#include "recording/pcd/writer.hpp"
#include "recording/sources/extras.hpp"
#include "recording/sources/frame_sink.hpp"
#include "recording/sources/frame_source.hpp"
#include "tests/support/run_command.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/recording/mcap/mcap_bytes.hpp"
#include "tests/unit/recording/recording_files.hpp"

namespace cleave::recording {
namespace {

using recording::PcdCloud;

std::size_t convert(const std::filesystem::path& from, const std::filesystem::path& to) {
  const auto source = open_frame_source(from, "camera");
  const auto sink = open_frame_sink(to);
  std::size_t count = 0;
  while (auto frame = source->next()) {
    sink->write(std::move(*frame));
    ++count;
  }
  sink->close();
  return count;
}

std::vector<float> points_of(const std::filesystem::path& pcd) {
  const PcdCloud cloud = PcdCloud::read(pcd);
  return {cloud.xyz().begin(), cloud.xyz().end()};
}

class Convert : public testing::Test {
 protected:
  tests::TemporaryFolder folder_;
  const std::filesystem::path mcap_ = folder_.path() / "a.mcap";
  const std::filesystem::path pcds_ = folder_.path() / "pcds";
};

TEST_F(Convert, GivesEveryPointBackFromPcdThroughMcapToPcd) {
  std::filesystem::create_directory(pcds_);
  const recording::Cloud image = recording::depth_cloud(1);
  const recording::Cloud free = recording::free_cloud(2);
  write_pcd(pcds_ / "1.pcd", PcdCloud::of_points(image.xyz, 32, 24));
  write_pcd(pcds_ / "2.pcd", PcdCloud::of_points(free.xyz, 100, 1));
  EXPECT_EQ(convert(pcds_, mcap_), 2U);
  EXPECT_EQ(convert(mcap_, folder_.path() / "again"), 2U);
  EXPECT_TRUE(
      recording::same_points(points_of(folder_.path() / "again" / "frame_000001.pcd"), image.xyz));
  EXPECT_TRUE(
      recording::same_points(points_of(folder_.path() / "again" / "frame_000002.pcd"), free.xyz));
}

TEST_F(Convert, PutsRecordedLabelsIntoTheirPcd) {
  recording::write_frames(mcap_, 3, 4096);
  EXPECT_EQ(convert(mcap_, pcds_), 9U);
  const PcdCloud cloud = PcdCloud::read(pcds_ / "frame_000003.pcd");
  EXPECT_TRUE(cloud.header().find("label"));
}

TEST_F(Convert, WritesCloudsWithoutLabelsToo) {
  recording::FrameWriter writer(mcap_);
  for (std::uint64_t id = 1; id <= 40; ++id) writer.write({1, recording::depth_cloud(id)});
  writer.close();
  EXPECT_EQ(convert(mcap_, pcds_), 40U);
  EXPECT_TRUE(std::filesystem::exists(pcds_ / "frame_000040.pcd"));
  EXPECT_FALSE(PcdCloud::read(pcds_ / "frame_000040.pcd").header().find("label"));
}

TEST_F(Convert, LeavesOutWhatItCannotReadAndCountsIt) {
  std::filesystem::create_directory(pcds_);
  write_pcd(pcds_ / "1.pcd", PcdCloud::of_points(recording::depth_cloud(1).xyz, 32, 24));
  write_pcd(pcds_ / "3.pcd", PcdCloud::of_points(recording::depth_cloud(1).xyz, 32, 24));
  (void)folder_.file("pcds/2.pcd", "no cloud");
  const auto source = open_frame_source(pcds_, "camera");
  EXPECT_TRUE(source->next());
  EXPECT_TRUE(source->next());
  EXPECT_FALSE(source->next());
  EXPECT_EQ(source->skipped(), 1U);
}

TEST_F(Convert, ReplacesNothing) {
  recording::write_frames(mcap_, 1, 4096);
  EXPECT_THROW((void)open_frame_sink(mcap_), std::runtime_error);
}

TEST_F(Convert, RefusesOtherKindsOfFiles) {
  EXPECT_THROW((void)open_frame_source(folder_.file("a.txt", "text"), "camera"), UnknownInput);
  EXPECT_THROW((void)open_frame_source(folder_.path() / "absent.pcd", "camera"),
               std::runtime_error);
}

TEST_F(Convert, KeepsAttachmentsAndMetadataFromRecordingToRecording) {
  recording::McapBytes file = recording::begun_file();
  file.attachment("a.txt", "one").metadata("notes").attachment("b.txt", "two").footer();
  recording::write_all(mcap_, file.bytes());
  const std::filesystem::path copy = folder_.path() / "copy.mcap";
  const auto sink = open_frame_sink(copy);
  EXPECT_EQ(copy_extras(mcap_, *sink), 0U);
  sink->close();
  recording::McapReader reader(copy);
  reader.check_attachments();
  EXPECT_TRUE(reader.problems().empty());
  ASSERT_EQ(reader.contents().attachments.size(), 2U);
  EXPECT_EQ(reader.contents().attachments[1].name, "b.txt");
  ASSERT_EQ(reader.contents().metadata.size(), 1U);
  EXPECT_EQ(reader.contents().metadata[0].name, "notes");
}

TEST_F(Convert, KeepsTheAttachmentsOfARecordingWhateverItsNameEndsIn) {
  recording::McapBytes file = recording::begun_file();
  file.attachment("a.txt", "one").footer();
  recording::write_all(mcap_, file.bytes());
  const std::filesystem::path run = folder_.path() / "run.mcap";
  const auto sink = open_frame_sink(run);
  sink->write({1, recording::depth_cloud(1)});
  EXPECT_EQ(copy_extras(mcap_, *sink), 0U);
  sink->close();
  const std::filesystem::path unnamed = folder_.path() / "recording.bak";
  std::filesystem::rename(run, unnamed);
  const std::filesystem::path copy = folder_.path() / "copy.mcap";
  EXPECT_EQ(tests::run_command(client::add_convert_command,
                               {"convert", "mcap:" + unnamed.string(), copy}),
            exit_done);
  EXPECT_EQ(recording::McapReader(copy).contents().attachments.size(), 1U);
}

TEST_F(Convert, NamesAndLeavesOutAnAttachmentThatIsDamaged) {
  recording::McapBytes file = recording::begun_file();
  const std::uint64_t end = file.attachment("a.txt", "one").size();
  file.footer();
  recording::Bytes bytes = file.bytes();
  bytes[end - 5] ^= std::byte{1};
  recording::write_all(mcap_, bytes);
  const auto sink = open_frame_sink(pcds_);
  EXPECT_EQ(copy_extras(mcap_, *sink), 1U);
}

}  // namespace
}  // namespace cleave::recording
