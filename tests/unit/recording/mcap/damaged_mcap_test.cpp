// SPDX-License-Identifier: BSD-3-Clause
// Files that lie: no crash, no hang, an error or what is intact.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <random>

#include "recording/frames/frame_reader.hpp"
#include "recording/mcap/recover.hpp"
#include "recording/mcap/writer.hpp"
#include "tests/unit/recording/recording_files.hpp"

namespace cleave::recording {
namespace {

constexpr std::uint64_t frames_written = 12;
constexpr std::chrono::seconds longest{5};

// The messages of one frame of `file`, with that of one channel replaced.
void write_mutated(const std::filesystem::path& file, const std::filesystem::path& whole,
                   const Message& replaced, ByteView data) {
  McapReader reader(whole);
  McapWriter writer(file);
  while (const auto message = reader.next()) {
    if (message->sequence != replaced.sequence) continue;
    const auto schema =
        writer.add_schema(message->schema->name, message->schema->encoding, message->schema->text);
    const auto channel = writer.add_channel(schema, message->channel->topic, "cdr");
    const bool is_it = message->channel->id == replaced.channel->id;
    writer.write(channel, message->sequence, message->times, is_it ? data : message->data);
  }
  writer.close();
}

class DamagedMcap : public testing::Test {
 protected:
  DamagedMcap() {
    write_frames(file_, frames_written, 8192);
    whole_ = read_all(file_);
  }

  // Reads and recovers the file; every frame that comes back is one that was written.
  void check(const Bytes& bytes, const std::string& what) {
    const auto start = std::chrono::steady_clock::now();
    write_all(file_, bytes);
    read(what);
    try {
      (void)recover(file_, folder_.path() / "recovered.mcap");
    } catch (const FileError&) {
    }
    EXPECT_LT(std::chrono::steady_clock::now() - start, longest) << what;
  }

  void read(const std::string& what) {
    try {
      for (const Frame& frame : read_frames(file_)) check(frame, what);
    } catch (const FileError& error) {
      EXPECT_STRNE(error.what(), "");
    }
  }

  // A chunk's CRC lets nothing through that was changed.
  static void check(const Frame& frame, const std::string& what) {
    const std::uint64_t id = frame.header().frame_id;
    ASSERT_GE(id, 1U) << what;
    ASSERT_LE(id, frames_written) << what;
    if (const auto* const cloud = std::get_if<Cloud>(&frame.content)) {
      EXPECT_TRUE(same_points(cloud->xyz, depth_cloud(id).xyz)) << what;
    } else if (const auto* const map = std::get_if<Labels>(&frame.content)) {
      EXPECT_EQ(*map, labels(id)) << what;
    } else {
      EXPECT_EQ(std::get<SegmentList>(frame.content), segment_list(id)) << what;
    }
  }

  TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_.path() / "a.mcap";
  Bytes whole_;
};

TEST_F(DamagedMcap, Of1000MutationsGivesAnErrorOrWhatIsIntact) {
  std::mt19937 random(5);
  for (int i = 0; i < 1000; ++i) {
    Bytes bytes = whole_;
    const std::size_t changes = 1 + random() % 8;
    for (std::size_t c = 0; c < changes; ++c) {
      bytes[random() % bytes.size()] = std::byte{static_cast<unsigned char>(random())};
    }
    check(bytes, "mutation " + std::to_string(i));
  }
}

TEST_F(DamagedMcap, Of200TruncationsGivesAnErrorOrWhatIsIntact) {
  std::mt19937 random(6);
  for (int i = 0; i < 200; ++i) {
    Bytes bytes = whole_;
    bytes.resize(random() % bytes.size());
    check(bytes, "truncation " + std::to_string(i));
  }
}

// Behind a chunk's CRC: messages themselves that lie.
TEST_F(DamagedMcap, OfMutatedMessagesGivesAnErrorOrSomeFrame) {
  std::mt19937 random(7);
  McapReader reader(file_);
  while (const auto message = reader.next()) {
    for (int i = 0; i < 20; ++i) {
      const std::filesystem::path copy = folder_.path() / "mutated.mcap";
      Bytes data(message->data.begin(), message->data.end());
      const std::size_t head = std::min<std::size_t>(data.size(), 400);
      for (int c = 0; c < 3; ++c) {
        data[random() % head] = std::byte{static_cast<unsigned char>(random())};
      }
      write_mutated(copy, file_, *message, data);
      try {
        (void)read_frames(copy);
      } catch (const FileError&) {
      }
    }
    if (message->sequence >= 6) break;
  }
}

}  // namespace
}  // namespace cleave::recording
