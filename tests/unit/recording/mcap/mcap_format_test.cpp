// SPDX-License-Identifier: BSD-3-Clause
// What other recorders make of the format.
#include <algorithm>
#include <random>

#include "tests/unit/recording/mcap/mcap_format.hpp"

namespace cleave::recording {
namespace {

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
  ASSERT_EQ(contents_.problems.count(), 1U);
  EXPECT_NE(contents_.problems.texts().front().find("'rar'"), std::string::npos);
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
  ASSERT_EQ(contents_.problems.count(), 1U);
  EXPECT_NE(contents_.problems.texts().front().find("CRC"), std::string::npos);
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

TEST_F(McapFormat, IsWholeWithoutAnythingInIt) {
  McapBytes file;
  file.magic().header("ros2").footer();
  EXPECT_EQ(read(file), Numbers{});
  expect_whole();
  EXPECT_EQ(read_recovered(file), Numbers{});
  EXPECT_EQ(contents_.profile, "ros2");
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

}  // namespace
}  // namespace cleave::recording
