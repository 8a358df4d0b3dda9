// SPDX-License-Identifier: BSD-3-Clause
// Files that are made to be read for ever: the work is in proportion to their size.
#include <gtest/gtest.h>

#include "recording/mcap/reader.hpp"
#include "tests/unit/recording/mcap/mcap_bytes.hpp"
#include "tests/unit/recording/recording_files.hpp"

namespace cleave::recording {
namespace {

// Its name is longer than the record: it is damaged, and is read whole before that is seen.
Bytes bad_metadata() {
  Bytes content;
  append_number(content, ~std::uint32_t{0});
  append_number(content, std::uint32_t{0});
  return content;
}

// Its fields are right; what it spans behind them is not its own.
Bytes small_chunk() {
  Bytes content;
  append_number(content, std::uint64_t{1});
  append_number(content, std::uint64_t{1});
  append_number(content, std::uint64_t{0});
  append_number(content, std::uint32_t{0});
  append_string(content, "lz4");
  append_number(content, std::uint64_t{0});
  return content;
}

// Records, each within the one before, that all end at `end`, where the file's magic is.
Bytes nested(Opcode opcode, const Bytes& content, std::uint64_t end) {
  Bytes file = begun_file().bytes();
  while (file.size() + record_prefix_bytes + content.size() <= end) {
    append_number(file, opcode);
    append_number(file, end - file.size() - sizeof(std::uint64_t));
    append(file, content);
  }
  file.resize(end);
  append(file, bytes_of(mcap_magic));
  return file;
}

class HostileMcap : public testing::Test {
 protected:
  void expect_read_a_few_times(const Bytes& bytes) {
    constexpr std::uint64_t times = 200;  // small windows are read for small steps
    if (!bytes_read_so_far()) GTEST_SKIP() << "nobody counts the bytes that are read";
    write_all(file_, bytes);
    const std::uint64_t before = *bytes_read_so_far();
    McapReader reader(file_, Order::file);
    while (reader.next()) continue;
    EXPECT_LT(*bytes_read_so_far() - before, times * bytes.size());
    EXPECT_GT(reader.contents().problems.count(), 0U);
  }

  TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_.path() / "a.mcap";
};

constexpr std::uint64_t size = 300'000;

TEST_F(HostileMcap, OfDamagedRecordsInOneAnotherIsReadAFewTimes) {
  expect_read_a_few_times(nested(Opcode::metadata, bad_metadata(), size));
}

TEST_F(HostileMcap, OfChunksInOneAnotherIsReadAFewTimes) {
  expect_read_a_few_times(nested(Opcode::chunk, small_chunk(), size));
}

TEST_F(HostileMcap, OfOneDamagedRecordAfterTheOtherIsReadAFewTimes) {
  McapBytes file = begun_file();
  const Bytes content = bad_metadata();
  const std::string_view text(reinterpret_cast<const char*>(content.data()), content.size());
  while (file.size() < size) file.record(0x0C, text);
  expect_read_a_few_times(file.bytes());
}

TEST_F(HostileMcap, CountsMoreDamageThanItTells) {
  McapBytes file = begun_file();
  for (int i = 0; i < 3000; ++i) file.record(0x0C, "too short");
  file.message(1, 1).footer();
  write_all(file_, file.bytes());
  McapReader reader(file_);
  ASSERT_TRUE(reader.next());
  EXPECT_EQ(reader.contents().problems.count(), 3000U);
  EXPECT_EQ(reader.problems().size(), 1000U);
}

}  // namespace
}  // namespace cleave::recording
