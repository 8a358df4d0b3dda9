// SPDX-License-Identifier: BSD-3-Clause
// A recorder that is killed at any moment loses what its last chunk would have held, and no more.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <random>

#include "recording/frames/frame_reader.hpp"
#include "recording/frames/frame_writer.hpp"
#include "recording/mcap/recover.hpp"
#include "tests/unit/recording/recording_files.hpp"

namespace cleave::recording {
namespace {

constexpr std::size_t chunk_bytes = 20'000;
// A frame of 32 x 24 has 1,536 bytes of depth and some 700 of the rest; schemas count, too.
constexpr std::uint64_t most_frames_a_chunk = 12;

// Writes frames for ever, and a byte to the pipe for each that was handed to the writer.
[[noreturn]] void record_until_killed(const std::filesystem::path& file, int pipe) {
  FrameWriter writer(file, chunk_bytes);
  for (std::uint64_t id = 1;; ++id) {
    writer.write({static_cast<std::int64_t>(id), depth_cloud(id)});
    if (::write(pipe, "f", 1) != 1) ::_exit(1);
  }
}

// How many frames the killed process had handed to its writer.
std::uint64_t record_and_kill(const std::filesystem::path& file, useconds_t after_us) {
  int ends[2];
  if (::pipe(ends) != 0) return 0;
  const pid_t child = ::fork();
  if (child == 0) record_until_killed(file, ends[1]);
  ::close(ends[1]);
  ::usleep(after_us);
  ::kill(child, SIGKILL);
  int status = 0;
  ::waitpid(child, &status, 0);
  std::uint64_t handed_over = 0;
  char buffer[4096];
  for (ssize_t count = 0; (count = ::read(ends[0], buffer, sizeof buffer)) > 0;) {
    handed_over += static_cast<std::uint64_t>(count);
  }
  ::close(ends[0]);
  return handed_over;
}

TEST(KilledWriter, At50RandomMomentsLosesAtMostTheLastChunk) {
  std::mt19937 random(9);
  std::uniform_int_distribution<useconds_t> moment_us(2'000, 60'000);
  std::uint64_t most = 0;
  for (int i = 0; i < 50; ++i) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "killed.mcap";
    const std::uint64_t handed_over = record_and_kill(file, moment_us(random));
    if (handed_over <= most_frames_a_chunk) continue;  // killed before its first chunk was full
    most = std::max(most, handed_over);
    const std::filesystem::path whole = folder.path() / "whole.mcap";
    (void)recover(file, whole);
    const std::vector<Frame> frames = read_frames(whole);
    ASSERT_GE(frames.size() + most_frames_a_chunk, handed_over) << "moment " << i;
    for (std::size_t f = 0; f < frames.size(); ++f) {
      const std::uint64_t id = f + 1;
      EXPECT_EQ(frames[f].header().frame_id, id);
      EXPECT_TRUE(same_points(std::get<Cloud>(frames[f].content).xyz, depth_cloud(id).xyz));
    }
  }
  EXPECT_GT(most, most_frames_a_chunk) << "no recorder lived long enough to tell anything";
}

// A disk that has room for `most_bytes`: writes beyond that fail. In a process of its own.
[[noreturn]] void record_onto_full_disk(const std::filesystem::path& file, rlim_t most_bytes) {
  const rlimit limit{most_bytes, most_bytes};
  ::signal(SIGXFSZ, SIG_IGN);
  if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) ::_exit(2);
  FrameWriter writer(file, chunk_bytes);
  try {
    for (std::uint64_t id = 1;; ++id) {
      writer.write({static_cast<std::int64_t>(id), depth_cloud(id)});
    }
  } catch (const FileError&) {
    ::_exit(0);
  }
}

TEST(FullDisk, LeavesWholeChunksAndNoHalfOfOne) {
  for (const rlim_t most_bytes : {10'000U, 20'011U, 33'333U, 50'007U}) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "full.mcap";
    const pid_t child = ::fork();
    if (child == 0) record_onto_full_disk(file, most_bytes);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << most_bytes;
    const McapReader reader(file);
    EXPECT_TRUE(reader.problems().empty()) << "half a chunk was left behind";
    EXPECT_FALSE(reader.contents().chunks.empty());
    const std::vector<Frame> frames = read_frames(file);
    ASSERT_FALSE(frames.empty());
    EXPECT_EQ(frames.back().header().frame_id, frames.size());
  }
}

}  // namespace
}  // namespace cleave::recording
