// SPDX-License-Identifier: BSD-3-Clause
// Files of other recorders that lie: no crash, no hang, no memory that a size asks for in vain.
#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "recording/mcap/reader.hpp"
#include "recording/mcap/recover.hpp"
#include "tests/unit/recording/mcap/mcap_bytes.hpp"
#include "tests/unit/recording/recording_files.hpp"

namespace cleave::recording {
namespace {

constexpr std::uint32_t messages_written = 30;

// Of everything that the format has.
Bytes rich_file() {
  McapBytes file = begun_file(true);
  std::uint32_t number = 0;
  for (const char* const compression : {"", "lz4", "zstd"}) {
    McapBytes records(true);
    records.schema(2).channel(2, 2, "another/topic").channel(3, 0, "no/schema");
    for (std::uint32_t i = 0; i < 8; ++i, ++number) {
      records.message(number, 100 - number, static_cast<std::uint16_t>(1 + i % 3), 10);
    }
    file.chunk(records, 0, 100, compression).record(0x07, std::string(22, '\0'));
    file.message(number, number).message(number + 1, number + 1, 2);
    file.attachment("a.txt", "some text").metadata("notes").record(0x81, "private");
    number += 2;
  }
  file.data_end();
  const std::uint64_t summary = file.size();
  file.schema().channel().schema(2).channel(2, 2, "another/topic").statistics(messages_written);
  file.footer(summary);
  return file.bytes();
}

class DamagedFormat : public testing::Test {
 protected:
  void check(const Bytes& bytes, const std::string& what) {
    write_all(file_, bytes);
    for (const Order order : {Order::file, Order::log_time}) {
      try {
        McapReader reader(file_, order);
        std::size_t count = 0;
        while (reader.next()) ++count;
        reader.check_attachments();
        reader.check_totals(count);
        // One that is found twice, in a damaged chunk and behind it, would be worse than lost.
        EXPECT_LE(count, messages_written) << what;
      } catch (const FileError&) {
      }
    }
    try {
      const Recovery recovery = recover(file_, copy_);
      McapReader copy(copy_, Order::file);
      std::uint64_t count = 0;
      while (copy.next()) ++count;
      EXPECT_EQ(count, recovery.messages) << what;
      EXPECT_TRUE(copy.problems().empty()) << what << ": " << copy.problems().front();
    } catch (const FileError&) {
    }
  }

  TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_.path() / "a.mcap";
  const std::filesystem::path copy_ = folder_.path() / "copy.mcap";
  const Bytes whole_ = rich_file();
};

TEST_F(DamagedFormat, IsWholeBeforeItIsDamaged) {
  write_all(file_, whole_);
  const Recovery recovery = recover(file_, copy_);
  EXPECT_EQ(recovery.messages, messages_written);
  EXPECT_EQ(recovery.attachments, 3U);
  EXPECT_EQ(recovery.metadata, 3U);
}

TEST_F(DamagedFormat, Survives1000Mutations) {
  std::mt19937 random(8);
  for (int i = 0; i < 1000; ++i) {
    Bytes bytes = whole_;
    const std::size_t changes = 1 + random() % 6;
    for (std::size_t c = 0; c < changes; ++c) {
      bytes[random() % bytes.size()] = std::byte{static_cast<unsigned char>(random())};
    }
    check(bytes, "mutation " + std::to_string(i));
  }
}

TEST_F(DamagedFormat, Survives200Truncations) {
  std::mt19937 random(9);
  for (int i = 0; i < 200; ++i) {
    Bytes bytes = whole_;
    bytes.resize(random() % bytes.size());
    check(bytes, "truncation " + std::to_string(i));
  }
}

// Sizes of 8 bytes at every place: 1 TB, and all that there is.
TEST_F(DamagedFormat, SurvivesSizesThatLie) {
  for (const std::uint64_t lie : {std::uint64_t{1} << 40U, ~std::uint64_t{0}}) {
    for (std::size_t at = 0; at + sizeof lie <= whole_.size(); at += 3) {
      Bytes bytes = whole_;
      std::memcpy(bytes.data() + at, &lie, sizeof lie);
      check(bytes, "a size at byte " + std::to_string(at));
    }
  }
}

}  // namespace
}  // namespace cleave::recording
