// SPDX-License-Identifier: BSD-3-Clause
// Frames on their way to the disk: a bounded queue and the thread that empties it.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "recording/frames/frame.hpp"
#include "recording/frames/frame_writer.hpp"

namespace cleave::client {

struct RecordingLimits {
  std::size_t queue_bytes = std::size_t{128} << 20U;        // that wait for a slow disk
  std::uint64_t reserve_bytes = std::uint64_t{256} << 20U;  // of the disk, left to others
  std::optional<std::uint64_t> max_file_bytes;
};

struct RecordingState {
  std::map<recording::Kind, std::uint64_t> written;
  std::map<recording::Kind, std::uint64_t> dropped;  // the disk was too slow
  std::uint64_t file_bytes = 0;
  std::uint64_t disk_left_bytes = 0;
  std::string stopped;  // why nothing more is written; empty while it is
  bool failed = false;  // because of an error
};

// A frame is written whole or dropped whole. What was written a second ago is in the file, whatever
// happens to this process.
class BackgroundWriter {
 public:
  // Creates the file. Throws recording::FileError, also when the disk has no room to begin with.
  explicit BackgroundWriter(const std::filesystem::path& path, const RecordingLimits& limits = {});
  ~BackgroundWriter();
  BackgroundWriter(const BackgroundWriter&) = delete;
  BackgroundWriter& operator=(const BackgroundWriter&) = delete;

  // Never waits for the disk. False: dropped and counted, for the queue is full.
  bool offer(recording::Frame frame);
  [[nodiscard]] RecordingState state() const;
  // Writes what still waits, these entries with the counts as metadata, and the end of the file.
  // Throws recording::FileError: what was written before can be recovered. Once.
  void finish(recording::Texts entries);

 private:
  // What came of a frame and of the time that has passed.
  struct Outcome {
    std::string failure;
    std::uint64_t file_bytes = 0;
    std::optional<std::uint64_t> disk_left_bytes;  // where it was looked at
  };
  void run();
  [[nodiscard]] Outcome write(const std::optional<recording::Frame>& frame);
  void account(const std::optional<recording::Frame>& frame, const Outcome& outcome);
  void check_room(std::uint64_t disk_left_bytes);
  void stop(const std::string& why, bool failed);

  std::filesystem::path path_;
  RecordingLimits limits_;
  recording::FrameWriter writer_;                  // of the thread, until that has ended
  std::chrono::steady_clock::time_point flushed_;  // of the thread

  mutable std::mutex mutex_;  // guards all below but the thread
  std::condition_variable changed_;
  std::deque<recording::Frame> queue_;
  std::size_t queued_bytes_ = 0;
  bool finishing_ = false;
  RecordingState state_;
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace cleave::client
