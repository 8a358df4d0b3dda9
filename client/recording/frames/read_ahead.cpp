// SPDX-License-Identifier: BSD-3-Clause
#include "recording/frames/read_ahead.hpp"

#include <exception>
#include <utility>

namespace cleave::recording {

ReadAhead::ReadAhead(const std::filesystem::path& path, const Selection& selection, bool loop,
                     std::size_t frames_ahead)
    : ReadAhead(std::make_unique<FrameReader>(path, selection), loop, frames_ahead) {}

ReadAhead::ReadAhead(std::unique_ptr<FrameInput> input, bool loop, std::size_t frames_ahead)
    : loop_(loop), frames_ahead_(frames_ahead), input_(std::move(input)) {
  thread_ = std::thread([this] { run(); });
}

ReadAhead::~ReadAhead() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

ReadAhead::Result ReadAhead::next(std::chrono::milliseconds timeout, AheadFrame& frame) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, timeout, [this] { return !ready_.empty() || ended_; });
  if (ready_.empty()) {
    if (!failure_.empty()) throw FileError(failure_);
    return ended_ ? Result::end : Result::timeout;
  }
  frame = std::move(ready_.front());
  ready_.pop_front();
  changed_.notify_all();
  return Result::frame;
}

std::vector<std::string> ReadAhead::problems() const {
  const std::lock_guard lock(mutex_);
  return problems_;
}

std::map<std::string, std::uint64_t> ReadAhead::losses() const {
  const std::lock_guard lock(mutex_);
  return losses_;
}

void ReadAhead::run() {
  try {
    std::uint64_t number = 0;
    while (pass(number) > 0 && loop_) {
      ++number;
      input_->rewind();
    }
    end("");
  } catch (const std::exception& error) {
    end(error.what());
  }
}

// How many frames were handed over; 0 when asked to stop.
std::size_t ReadAhead::pass(std::uint64_t number) {
  std::size_t count = 0;
  while (auto frame = input_->next()) {
    if (!hand_over({std::move(*frame), number})) return 0;
    ++count;
  }
  return count;
}

bool ReadAhead::hand_over(AheadFrame frame) {
  std::map<std::string, std::uint64_t> losses = input_->losses();
  std::unique_lock lock(mutex_);
  losses_ = std::move(losses);
  changed_.wait(lock, [this] { return ready_.size() < frames_ahead_ || stop_; });
  if (stop_) return false;
  ready_.push_back(std::move(frame));
  changed_.notify_all();
  return true;
}

void ReadAhead::end(const std::string& failure) {
  std::vector<std::string> problems = input_->problems();
  std::map<std::string, std::uint64_t> losses = input_->losses();
  const std::lock_guard lock(mutex_);
  failure_ = failure;
  problems_ = std::move(problems);
  losses_ = std::move(losses);
  ended_ = true;
  changed_.notify_all();
}

}  // namespace cleave::recording
