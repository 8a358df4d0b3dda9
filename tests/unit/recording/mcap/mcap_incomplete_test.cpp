// SPDX-License-Identifier: BSD-3-Clause
// Files that lack something, or of which something is damaged: all else is read and kept.
#include "tests/unit/recording/mcap/mcap_format.hpp"

namespace cleave::recording {
namespace {

class McapIncomplete : public McapFormat {};

TEST_F(McapIncomplete, RepeatsChannelsAtTheEndWhichHelpsWhenTheirChunkIsDamaged) {
  McapBytes first;
  first.schema().channel().message(1, 1);
  McapBytes second;
  second.message(2, 2);
  McapBytes file;
  file.magic().header();
  const std::uint64_t chunk_end = file.chunk(first, 1, 1).size();
  file.chunk(second, 2, 2).data_end();
  const std::uint64_t summary = file.size();
  file.schema().channel().footer(summary);
  Bytes bytes = file.bytes();
  bytes[chunk_end - 1] ^= std::byte{1};
  write_all(file_, bytes);
  EXPECT_EQ(recover(file_, copy_).messages, 1U);
  McapReader reader(copy_);
  const auto message = reader.next();
  ASSERT_TRUE(message);
  EXPECT_EQ(message->sequence, 2U);
  EXPECT_EQ(message->schema->name, "a/Type");
}

TEST_F(McapIncomplete, IsReadToItsEndWhereNobodyClosedIt) {
  McapBytes file = begun_file();
  file.message(1, 1).message(2, 2);
  EXPECT_EQ(read(file), (Numbers{1, 2}));
  EXPECT_FALSE(contents_.closed);
  EXPECT_TRUE(contents_.problems.empty());
}

TEST_F(McapIncomplete, IsNotWholeWhenItsStatisticsAnnounceMore) {
  McapBytes file = begun_file();
  file.message(1, 1).data_end();
  const std::uint64_t summary = file.size();
  file.statistics(2).footer(summary);
  EXPECT_EQ(read(file), Numbers{1});
  ASSERT_EQ(contents_.problems.count(), 1U);
  EXPECT_NE(contents_.problems.texts().front().find("announce 2 messages"), std::string::npos);
}

TEST_F(McapIncomplete, CoversMessagesOutsideOfChunksByTheCrcOfAllData) {
  McapBytes file = begun_file();
  const std::uint64_t end = file.message(1, 1).size();
  file.data_end().footer();
  Bytes bytes = file.bytes();
  bytes[end - 1] ^= std::byte{1};
  write_all(file_, bytes);
  EXPECT_EQ(recover(file_, copy_).problems.count(), 1U);
}

TEST_F(McapIncomplete, LosesTheAttachmentThatIsDamagedAndNothingElse) {
  McapBytes file = begun_file();
  file.message(1, 1).attachment("a.txt", "one");
  const std::uint64_t end = file.size();
  file.attachment("b.txt", "two").message(2, 2).footer();
  Bytes bytes = file.bytes();
  bytes[end - sizeof(std::uint32_t) - 1] ^= std::byte{1};
  write_all(file_, bytes);
  const Recovery recovery = recover(file_, copy_);
  EXPECT_EQ(recovery.messages, 2U);
  EXPECT_EQ(recovery.attachments, 1U);
  ASSERT_EQ(recovery.problems.count(), 1U);
  EXPECT_NE(recovery.problems.texts().front().find("'a.txt'"), std::string::npos);
}

TEST_F(McapIncomplete, IsReadOnBehindDamageBetweenMessagesOutsideOfChunks) {
  McapBytes file = begun_file();
  for (std::uint32_t i = 1; i <= 3; ++i) file.message(i, i);
  const std::uint64_t fourth = file.size();
  for (std::uint32_t i = 4; i <= 9; ++i) file.message(i, i);
  file.data_end().footer();
  Bytes bytes = file.bytes();
  bytes[fourth + 7] = std::byte{0x7F};  // of the length's 8 bytes
  write_all(file_, bytes);
  const Recovery recovery = recover(file_, copy_);
  EXPECT_EQ(recovery.messages, 8U);
  EXPECT_EQ(recovery.problems.count(), 1U);
}

TEST_F(McapIncomplete, NamesMessagesOfAChannelThatIsNowhereDescribed) {
  McapBytes file = begun_file();
  file.message(1, 1).message(2, 2, 77).message(3, 3, 77).message(4, 4).footer();
  EXPECT_EQ(read(file), (Numbers{1, 4}));
  ASSERT_EQ(contents_.problems.count(), 1U);
  EXPECT_NE(contents_.problems.texts().front().find("channel 77"), std::string::npos);
}

TEST_F(McapIncomplete, KeepsMessagesWhoseSchemaIsLost) {
  McapBytes file;
  file.magic().header().channel(1, 9).message(1, 1).footer();
  EXPECT_EQ(read(file), Numbers{1});
  EXPECT_EQ(contents_.problems.count(), 1U);
  EXPECT_EQ(read_recovered(file), Numbers{1});
}

}  // namespace
}  // namespace cleave::recording
