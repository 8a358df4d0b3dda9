// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "recording/mcap/reader.hpp"
#include "recording/mcap/recover.hpp"
#include "recording/mcap/writer.hpp"
#include "tests/unit/recording/recording_files.hpp"

namespace cleave::recording {
namespace {

// `count` messages of one channel, `per_chunk` in each chunk: message i has time i and i bytes.
void write_messages(const std::filesystem::path& file, std::uint64_t count, std::uint64_t per_chunk,
                    bool close = true) {
  McapWriter writer(file);
  const auto schema = writer.add_schema("a/Type", "ros2msg", "uint8 x\n");
  const auto channel = writer.add_channel(schema, "a/topic", "cdr", {{"key", "value"}});
  for (std::uint64_t i = 1; i <= count; ++i) {
    const Bytes data(i, std::byte{static_cast<unsigned char>(i)});
    writer.write(channel, static_cast<std::uint32_t>(i), {i, 2 * i}, data);
    if (i % per_chunk == 0) writer.flush();
  }
  if (close) {
    writer.add_metadata({"notes", {{"a", "b"}}});
    writer.close();
  }
}

std::vector<std::uint64_t> times_of(McapReader& reader) {
  std::vector<std::uint64_t> times;
  while (const auto message = reader.next()) times.push_back(message->times.log_ns);
  return times;
}

std::vector<std::uint64_t> range(std::uint64_t first, std::uint64_t last) {
  std::vector<std::uint64_t> result;
  for (std::uint64_t i = first; i <= last; ++i) result.push_back(i);
  return result;
}

class Mcap : public testing::Test {
 protected:
  TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_.path() / "a.mcap";
};

TEST_F(Mcap, GivesBackMessagesChannelsSchemasAndMetadata) {
  write_messages(file_, 10, 3);
  McapReader reader(file_);
  EXPECT_TRUE(reader.contents().closed);
  EXPECT_EQ(reader.contents().message_counts.at("a/topic"), 10U);
  const std::vector<Metadata> expected = {{"notes", {{"a", "b"}}}};
  EXPECT_EQ(reader.contents().metadata, expected);
  const auto message = reader.next();
  ASSERT_TRUE(message);
  EXPECT_EQ(message->channel->topic, "a/topic");
  EXPECT_EQ(message->channel->metadata.at("key"), "value");
  EXPECT_EQ(message->schema->text, "uint8 x\n");
  EXPECT_EQ(message->times.publish_ns, 2U);
  EXPECT_EQ(message->data.size(), 1U);
  EXPECT_EQ(times_of(reader), range(2, 10));
  EXPECT_TRUE(reader.problems().empty());
}

TEST_F(Mcap, HoldsNothingWhenNothingWasWritten) {
  write_messages(file_, 0, 1);
  McapReader reader(file_);
  EXPECT_TRUE(reader.contents().closed);
  EXPECT_FALSE(reader.next());
}

TEST_F(Mcap, ReadsOnlyTheTimesThatAreAskedFor) {
  write_messages(file_, 100, 7);
  McapReader reader(file_);
  reader.limit(20, 30);
  EXPECT_EQ(times_of(reader), range(20, 30));
  reader.limit(99, 1000);
  EXPECT_EQ(times_of(reader), range(99, 100));
}

TEST_F(Mcap, IsReadWithoutItsIndexWhenItWasCutOff) {
  write_messages(file_, 10, 2, false);
  McapReader reader(file_);
  EXPECT_FALSE(reader.contents().closed);
  EXPECT_EQ(times_of(reader), range(1, 10));
}

TEST_F(Mcap, LosesOnlyTheChunkThatIsDamaged) {
  write_messages(file_, 12, 4);
  const ChunkPlace second = McapReader(file_).contents().chunks.at(1);
  Bytes bytes = read_all(file_);
  bytes[second.offset + second.length - 1] ^= std::byte{1};
  write_all(file_, bytes);
  McapReader reader(file_);
  std::vector<std::uint64_t> expected = range(1, 4);
  for (const std::uint64_t time : range(9, 12)) expected.push_back(time);
  EXPECT_EQ(times_of(reader), expected);
  EXPECT_EQ(reader.problems().size(), 1U);
}

TEST_F(Mcap, PassesOverRecordsThatItDoesNotKnow) {
  write_messages(file_, 4, 4, false);
  Bytes bytes = read_all(file_);
  const std::size_t after_header =
      mcap_magic.size() + record_prefix_bytes + 4 + 4 + std::string("cleave").size();
  Bytes unknown;
  append_record(unknown, Opcode{0x0A}, bytes_of("an attachment index"));
  bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(after_header), unknown.begin(),
               unknown.end());
  write_all(file_, bytes);
  McapReader reader(file_);
  EXPECT_EQ(times_of(reader), range(1, 4));
  EXPECT_TRUE(reader.problems().empty());
}

TEST_F(Mcap, GoesOnBehindALengthThatLies) {
  write_messages(file_, 12, 4, false);
  const ChunkPlace second = McapReader(file_).contents().chunks.at(1);
  Bytes bytes = read_all(file_);
  bytes[second.offset + 7] = std::byte{0x7F};  // of the length's 8 bytes
  write_all(file_, bytes);
  McapReader reader(file_);
  std::vector<std::uint64_t> expected = range(1, 4);
  for (const std::uint64_t time : range(9, 12)) expected.push_back(time);
  EXPECT_EQ(times_of(reader), expected);
  EXPECT_FALSE(reader.problems().empty());
}

TEST_F(Mcap, RefusesWhatIsNoMcap) {
  write_all(file_, bytes_of("some text that is no recording"));
  EXPECT_THROW(McapReader reader(file_), FileError);
  write_all(file_, {});
  EXPECT_THROW(McapReader reader(file_), FileError);
  EXPECT_THROW(McapReader reader(folder_.path()), FileError);
  EXPECT_THROW(McapReader reader(folder_.path() / "absent"), FileError);
}

TEST_F(Mcap, IsMadeWholeByRecover) {
  write_messages(file_, 12, 4);
  Bytes bytes = read_all(file_);
  const ChunkPlace last = McapReader(file_).contents().chunks.at(2);
  bytes.resize(last.offset + last.length / 2);
  write_all(file_, bytes);
  const std::filesystem::path whole = folder_.path() / "whole.mcap";
  const Recovery recovery = recover(file_, whole);
  EXPECT_EQ(recovery.messages, 8U);
  EXPECT_EQ(recovery.problems.count(), 1U);
  McapReader reader(whole);
  EXPECT_TRUE(reader.contents().closed);
  EXPECT_EQ(times_of(reader), range(1, 8));
  EXPECT_TRUE(reader.problems().empty());
}

TEST_F(Mcap, IsNotRecoveredOntoItself) {
  write_messages(file_, 12, 4);
  const Bytes before = read_all(file_);
  EXPECT_THROW((void)recover(file_, file_), FileError);
  EXPECT_EQ(read_all(file_), before);
}

TEST(McapWriter, SaysWhyAFileCannotBeWritten) {
  EXPECT_THROW(McapWriter writer("/proc/no/such/folder/a.mcap"), FileError);
}

TEST(McapWriter, SaysThatTheDiskIsFull) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "this machine has no /dev/full";
  try {
    McapWriter writer("/dev/full");
    FAIL() << "nothing was said";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("No space left"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace cleave::recording
