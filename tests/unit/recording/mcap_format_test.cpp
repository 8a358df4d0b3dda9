// What other recorders make of the format.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "recording/mcap/reader.hpp"
#include "recording/mcap/recover.hpp"
#include "tests/unit/recording/mcap_bytes.hpp"
#include "tests/unit/recording/recording_files.hpp"

namespace cleave::recording {
namespace {

using Numbers = std::vector<std::uint32_t>;

class McapFormat : public testing::Test {
 protected:
  // What is read of a file with these bytes, in this order.
  Numbers read(const McapBytes& bytes, Order order = Order::file) {
    write_all(file_, bytes.bytes());
    McapReader reader(file_, order);
    Numbers numbers;
    while (const auto message = reader.next()) numbers.push_back(message->sequence);
    reader.check_attachments();
    reader.check_totals(numbers.size());
    contents_ = reader.contents();
    return numbers;
  }

  // What is read after recover() has copied it.
  Numbers read_recovered(const McapBytes& bytes) {
    write_all(file_, bytes.bytes());
    recovery_ = recover(file_, copy_);
    McapReader reader(copy_, Order::file);
    Numbers numbers;
    while (const auto message = reader.next()) numbers.push_back(message->sequence);
    reader.check_attachments();
    reader.check_totals(numbers.size());
    EXPECT_TRUE(reader.problems().empty()) << reader.problems().front();
    EXPECT_TRUE(reader.contents().closed);
    contents_ = reader.contents();
    return numbers;
  }

  void expect_whole() const {
    EXPECT_TRUE(contents_.closed);
    EXPECT_TRUE(contents_.problems.empty()) << contents_.problems.front();
  }

  TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_.path() / "a.mcap";
  const std::filesystem::path copy_ = folder_.path() / "copy.mcap";
  Contents contents_;
  Recovery recovery_;
};

TEST_F(McapFormat, HasMessagesOutsideOfChunks) {
  McapBytes file = begun_file();
  for (std::uint32_t i = 1; i <= 5; ++i) file.message(i, i);
  file.data_end().footer();
  EXPECT_EQ(read(file), (Numbers{1, 2, 3, 4, 5}));
  expect_whole();
  EXPECT_EQ(read_recovered(file), (Numbers{1, 2, 3, 4, 5}));
}

TEST_F(McapFormat, HasMessagesTooLargeForTheChunksBetweenThem) {
  McapBytes small;
  small.message(1, 1).message(2, 2);
  McapBytes more;
  more.message(4, 4);
  McapBytes file = begun_file();
  file.chunk(small, 1, 2).message(3, 3, 1, 3'000'000).chunk(more, 4, 4).message(5, 5);
  file.data_end().footer();
  EXPECT_EQ(read(file), (Numbers{1, 2, 3, 4, 5}));
  EXPECT_EQ(read(file, Order::log_time), (Numbers{1, 2, 3, 4, 5}));
  expect_whole();
  EXPECT_EQ(read_recovered(file), (Numbers{1, 2, 3, 4, 5}));
}

TEST_F(McapFormat, NeedsNoSchemaForAChannel) {
  McapBytes file;
  file.magic().header().channel(1, 0).message(1, 1).data_end().footer();
  write_all(file_, file.bytes());
  McapReader reader(file_);
  const auto message = reader.next();
  ASSERT_TRUE(message);
  EXPECT_EQ(message->schema->id, 0U);
  EXPECT_EQ(message->schema->name, "");
  EXPECT_EQ(read_recovered(file), Numbers{1});
}

TEST_F(McapFormat, LeavesOpcodesToApplications) {
  McapBytes records;
  records.schema().channel().record(0x90, "inside").message(1, 1);
  McapBytes file;
  file.magic().header().record(0x80, "mine").chunk(records, 1, 1).record(0xFF, "yours");
  file.record(0x10, "of the future").data_end().footer();
  EXPECT_EQ(read(file), Numbers{1});
  expect_whole();
  EXPECT_EQ(contents_.private_records, 2U);
  EXPECT_EQ(contents_.unknown_records, 1U);
  EXPECT_EQ(read_recovered(file), Numbers{1});
  EXPECT_TRUE(recovery_.problems.empty());
}

TEST_F(McapFormat, MayPutMoreBehindTheFieldsOfARecord) {
  McapBytes records(true);
  records.schema().channel().message(1, 1);
  McapBytes file = begun_file(true);
  file.chunk(records, 1, 1, "zstd").attachment("a.txt", "text").metadata("notes").message(2, 2);
  file.data_end();
  const std::uint64_t summary = file.size();
  file.schema().channel().footer(summary);
  EXPECT_EQ(read(file), (Numbers{1, 2}));
  expect_whole();
  EXPECT_EQ(read_recovered(file), (Numbers{1, 2}));
  EXPECT_EQ(recovery_.attachments, 1U);
  EXPECT_EQ(recovery_.metadata, 1U);
}

TEST_F(McapFormat, CompressesInTwoWaysOrNot) {
  for (const char* const compression : {"", "lz4", "zstd"}) {
    McapBytes records;
    records.schema().channel();
    for (std::uint32_t i = 1; i <= 100; ++i) records.message(i, i, 1, 1000);
    McapBytes file;
    file.magic().header().chunk(records, 1, 100, compression).data_end().footer();
    EXPECT_EQ(read(file).size(), 100U) << compression;
    expect_whole();
  }
}

TEST_F(McapFormat, NamesACompressionThatItDoesNotHave) {
  Bytes content(8 + 8 + 8 + 4);
  append_string(content, "rar");
  append_number(content, std::uint64_t{0});
  McapBytes file = begun_file();
  file.record(0x06, {reinterpret_cast<const char*>(content.data()), content.size()}).footer();
  EXPECT_EQ(read(file), Numbers{});
  ASSERT_EQ(contents_.problems.size(), 1U);
  EXPECT_NE(contents_.problems.front().find("'rar'"), std::string::npos);
}

TEST_F(McapFormat, DoesNotAskForACrcAndNamesAWrongOne) {
  McapBytes records;
  records.message(1, 1);
  McapBytes unsummed = begun_file();
  unsummed.chunk(records, 1, 1, "", false).footer();
  EXPECT_EQ(read(unsummed), Numbers{1});
  expect_whole();

  Bytes content(2 * sizeof(std::uint64_t));
  append_number(content, records.size());
  append_number(content, std::uint32_t{12345});
  append_string(content, "");
  append_number(content, records.size());
  append(content, records.bytes());
  McapBytes wrong = begun_file();
  wrong.record(0x06, {reinterpret_cast<const char*>(content.data()), content.size()}).footer();
  EXPECT_EQ(read(wrong), Numbers{});
  ASSERT_EQ(contents_.problems.size(), 1U);
  EXPECT_NE(contents_.problems.front().find("CRC"), std::string::npos);
}

TEST_F(McapFormat, OrdersNothingAndReplaysAreByLogTimeAllTheSame) {
  std::mt19937 random(3);
  for (int round = 0; round < 20; ++round) {
    struct Written {
      std::uint32_t number;
      std::uint64_t log_ns;
    };
    std::vector<Written> written;
    McapBytes file = begun_file();
    while (written.size() < 60) {
      McapBytes records;
      std::uint64_t start_ns = ~std::uint64_t{0};
      std::uint64_t end_ns = 0;
      const std::size_t count = 1 + random() % 6;
      for (std::size_t i = 0; i < count; ++i) {
        written.push_back({static_cast<std::uint32_t>(written.size()), 1 + random() % 40});
        records.message(written.back().number, written.back().log_ns);
        start_ns = std::min(start_ns, written.back().log_ns);
        end_ns = std::max(end_ns, written.back().log_ns);
      }
      file.chunk(records, start_ns, end_ns, "lz4");
      written.push_back({static_cast<std::uint32_t>(written.size()), 1 + random() % 40});
      file.message(written.back().number, written.back().log_ns);
    }
    file.data_end().footer();
    std::ranges::stable_sort(written, {}, &Written::log_ns);
    Numbers expected;
    for (const Written& message : written) expected.push_back(message.number);
    EXPECT_EQ(read(file, Order::log_time), expected);
    std::ranges::sort(expected);
    EXPECT_EQ(read(file), expected);
  }
}

TEST_F(McapFormat, MayLeaveTheTimesOfAChunkAtZero) {
  McapBytes late;
  late.message(2, 20).message(3, 30);
  McapBytes early;
  early.message(1, 10);
  McapBytes file = begun_file();
  file.chunk(late, 0, 0).chunk(early, 10, 10).footer();
  EXPECT_EQ(read(file, Order::log_time), (Numbers{1, 2, 3}));
}

TEST_F(McapFormat, DescribesAChannelOnceInAChunkThatIsNotAskedFor) {
  McapBytes first;
  first.schema().channel().message(1, 1);
  McapBytes second;
  second.message(2, 2);
  McapBytes file;
  file.magic().header().chunk(first, 1, 1).chunk(second, 2, 2).footer();
  write_all(file_, file.bytes());
  McapReader reader(file_);
  reader.limit(2, 2);
  const auto message = reader.next();
  ASSERT_TRUE(message);
  EXPECT_EQ(message->channel->topic, "a/topic");
  EXPECT_EQ(message->schema->name, "a/Type");
  EXPECT_TRUE(reader.problems().empty());
}

TEST_F(McapFormat, RepeatsChannelsAtTheEndWhichHelpsWhenTheirChunkIsDamaged) {
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

TEST_F(McapFormat, IsWholeWithoutAnythingInIt) {
  McapBytes file;
  file.magic().header("ros2").footer();
  EXPECT_EQ(read(file), Numbers{});
  expect_whole();
  EXPECT_EQ(read_recovered(file), Numbers{});
  EXPECT_EQ(contents_.profile, "ros2");
}

TEST_F(McapFormat, IsReadToItsEndWhereNobodyClosedIt) {
  McapBytes file = begun_file();
  file.message(1, 1).message(2, 2);
  EXPECT_EQ(read(file), (Numbers{1, 2}));
  EXPECT_FALSE(contents_.closed);
  EXPECT_TRUE(contents_.problems.empty());
}

TEST_F(McapFormat, IsNotWholeWhenItsStatisticsAnnounceMore) {
  McapBytes file = begun_file();
  file.message(1, 1).data_end();
  const std::uint64_t summary = file.size();
  file.statistics(2).footer(summary);
  EXPECT_EQ(read(file), Numbers{1});
  ASSERT_EQ(contents_.problems.size(), 1U);
  EXPECT_NE(contents_.problems.front().find("announce 2 messages"), std::string::npos);
}

TEST_F(McapFormat, CoversMessagesOutsideOfChunksByTheCrcOfAllData) {
  McapBytes file = begun_file();
  const std::uint64_t end = file.message(1, 1).size();
  file.data_end().footer();
  Bytes bytes = file.bytes();
  bytes[end - 1] ^= std::byte{1};
  write_all(file_, bytes);
  EXPECT_EQ(recover(file_, copy_).problems.size(), 1U);
}

TEST_F(McapFormat, KeepsAttachmentsMetadataAndMessagesInTheirOrder) {
  McapBytes file = begun_file();
  file.metadata("before").message(1, 1).attachment("a.txt", "one").message(2, 2);
  file.attachment("b.txt", "two").metadata("after").data_end().footer();
  EXPECT_EQ(read_recovered(file), (Numbers{1, 2}));
  ASSERT_EQ(contents_.attachments.size(), 2U);
  ASSERT_EQ(contents_.metadata.size(), 2U);
  EXPECT_EQ(contents_.attachments[1].name, "b.txt");
  EXPECT_EQ(contents_.attachments[1].data_bytes, 3U);
  EXPECT_EQ(contents_.attachments[1].create_ns, 6U);
  EXPECT_EQ(contents_.metadata[0].entries, (Texts{{"key", "value"}}));
  const std::vector<std::uint64_t> places = {
      contents_.metadata[0].offset,    contents_.chunks[0].offset,
      contents_.attachments[0].offset, contents_.chunks[1].offset,
      contents_.attachments[1].offset, contents_.metadata[1].offset};
  EXPECT_TRUE(std::ranges::is_sorted(places));
}

TEST_F(McapFormat, LosesTheAttachmentThatIsDamagedAndNothingElse) {
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
  ASSERT_EQ(recovery.problems.size(), 1U);
  EXPECT_NE(recovery.problems.front().find("'a.txt'"), std::string::npos);
}

TEST_F(McapFormat, IsReadOnBehindDamageBetweenMessagesOutsideOfChunks) {
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
  EXPECT_EQ(recovery.problems.size(), 1U);
}

TEST_F(McapFormat, NamesMessagesOfAChannelThatIsNowhereDescribed) {
  McapBytes file = begun_file();
  file.message(1, 1).message(2, 2, 77).message(3, 3, 77).message(4, 4).footer();
  EXPECT_EQ(read(file), (Numbers{1, 4}));
  ASSERT_EQ(contents_.problems.size(), 1U);
  EXPECT_NE(contents_.problems.front().find("channel 77"), std::string::npos);
}

TEST_F(McapFormat, KeepsMessagesWhoseSchemaIsLost) {
  McapBytes file;
  file.magic().header().channel(1, 9).message(1, 1).footer();
  EXPECT_EQ(read(file), Numbers{1});
  EXPECT_EQ(contents_.problems.size(), 1U);
  EXPECT_EQ(read_recovered(file), Numbers{1});
}

}  // namespace
}  // namespace cleave::recording
