// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/record/background_writer.hpp"

#include <spdlog/fmt/fmt.h>

#include <exception>
#include <utility>

#include "cleave/stream/topic_names.hpp"
#include "recording/error.hpp"

namespace cleave::client {
namespace {

using Clock = std::chrono::steady_clock;

// So long a frame waits for its chunk at most.
constexpr std::chrono::seconds flush_interval{1};
constexpr std::chrono::milliseconds tick{200};

std::size_t bytes_of(const recording::Frame& frame) {
  if (const auto* const cloud = std::get_if<recording::Cloud>(&frame.content)) {
    return sizeof frame + cloud->xyz.size() * sizeof(float);
  }
  if (const auto* const labels = std::get_if<recording::Labels>(&frame.content)) {
    return sizeof frame + labels->label.size() * sizeof(std::uint16_t);
  }
  return sizeof frame + std::get<recording::SegmentList>(frame.content).segments.size() *
                            sizeof(recording::Segment);
}

std::uint64_t available_bytes(const std::filesystem::path& path) {
  return std::filesystem::space(std::filesystem::absolute(path).parent_path()).available;
}

std::string no_room(const std::filesystem::path& path, std::uint64_t left, std::uint64_t reserve) {
  return fmt::format("{}: the disk has {} MB left, of which {} MB are kept for others",
                     path.string(), left >> 20U, reserve >> 20U);
}

}  // namespace

BackgroundWriter::BackgroundWriter(const std::filesystem::path& path, const RecordingLimits& limits)
    : path_(path), limits_(limits), writer_(path), flushed_(Clock::now()) {
  check_room(available_bytes(path_));
  if (!state_.stopped.empty()) {
    std::filesystem::remove(path_);
    throw recording::FileError(state_.stopped + "; make room, or name a file on another disk");
  }
  thread_ = std::thread([this] { run(); });
}

BackgroundWriter::~BackgroundWriter() {
  {
    const std::lock_guard lock(mutex_);
    finishing_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

bool BackgroundWriter::offer(recording::Frame frame) {
  const recording::Kind kind = frame.kind();
  const std::size_t bytes = bytes_of(frame);
  {
    const std::lock_guard lock(mutex_);
    if (!state_.stopped.empty() || queued_bytes_ + bytes > limits_.queue_bytes) {
      ++state_.dropped[kind];
      return false;
    }
    queued_bytes_ += bytes;
    queue_.push_back(std::move(frame));
  }
  changed_.notify_all();
  return true;
}

RecordingState BackgroundWriter::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

// The mutex is never held while the disk is waited for.
void BackgroundWriter::run() {
  while (true) {
    std::optional<recording::Frame> frame;
    {
      std::unique_lock lock(mutex_);
      changed_.wait_for(lock, tick, [this] { return !queue_.empty() || finishing_; });
      if (queue_.empty() && finishing_) return;
      if (!queue_.empty()) {
        frame = std::move(queue_.front());
        queue_.pop_front();
      }
    }
    const Outcome outcome = write(frame);
    const std::lock_guard lock(mutex_);
    account(frame, outcome);
    if (!state_.stopped.empty()) return;
  }
}

BackgroundWriter::Outcome BackgroundWriter::write(const std::optional<recording::Frame>& frame) {
  Outcome outcome;
  try {
    if (frame) writer_.write(*frame);
    if (Clock::now() - flushed_ >= flush_interval) {
      flushed_ = Clock::now();
      writer_.flush();
      outcome.disk_left_bytes = available_bytes(path_);
    }
  } catch (const std::exception& error) {
    outcome.failure = error.what();
  }
  outcome.file_bytes = writer_.size_bytes();
  return outcome;
}

void BackgroundWriter::account(const std::optional<recording::Frame>& frame,
                               const Outcome& outcome) {
  if (frame) queued_bytes_ -= bytes_of(*frame);
  if (!outcome.failure.empty()) return stop(outcome.failure, true);
  if (frame) ++state_.written[frame->kind()];
  state_.file_bytes = outcome.file_bytes;
  if (outcome.disk_left_bytes) check_room(*outcome.disk_left_bytes);
  if (limits_.max_file_bytes && state_.file_bytes >= *limits_.max_file_bytes) {
    stop("the file has the size that was asked for", false);
  }
}

void BackgroundWriter::check_room(std::uint64_t disk_left_bytes) {
  state_.disk_left_bytes = disk_left_bytes;
  if (disk_left_bytes < limits_.reserve_bytes) {
    stop(no_room(path_, disk_left_bytes, limits_.reserve_bytes), true);
  }
}

// What still waits is dropped.
void BackgroundWriter::stop(const std::string& why, bool failed) {
  state_.stopped = why;
  state_.failed = failed;
  for (const recording::Frame& frame : queue_) ++state_.dropped[frame.kind()];
  queue_.clear();
  queued_bytes_ = 0;
}

void BackgroundWriter::finish(recording::Texts entries) {
  {
    const std::lock_guard lock(mutex_);
    finishing_ = true;
  }
  changed_.notify_all();
  thread_.join();
  for (const recording::Kind kind :
       {recording::Kind::cloud, recording::Kind::labels, recording::Kind::segments}) {
    const std::string topic = topic_of(kind);
    entries["written " + topic] = std::to_string(state_.written[kind]);
    entries["dropped " + topic] = std::to_string(state_.dropped[kind]);
  }
  writer_.add_metadata({"cleave", std::move(entries)});
  writer_.close();
  state_.file_bytes = writer_.size_bytes();
}

}  // namespace cleave::client
