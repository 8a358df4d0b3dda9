// SPDX-License-Identifier: BSD-3-Clause
#include "recording/frames/read_ahead.hpp"

#include <exception>
#include <utility>

namespace cleave::recording {

ReadAhead::ReadAhead(const std::filesystem::path& path, const Selection& selection, bool loop,
                     std::size_t frames_ahead)
    : ReadAhead(std::make_unique<FrameReader>(path, selection), loop, frames_ahead) {}

ReadAhead::ReadAhead(std::unique_ptr<FrameInput> input, bool loop, std::size_t frames_ahead)
    : loop_(loop), input_(std::move(input)), ready_(frames_ahead) {
  thread_ = std::thread([this] { run(); });
}

ReadAhead::~ReadAhead() {
  ready_.stop();
  thread_.join();
}

ReadAhead::Result ReadAhead::next(std::chrono::milliseconds timeout, AheadFrame& frame) {
  const Result result = ready_.take(timeout, frame);
  if (result != Result::end) return result;
  const std::lock_guard lock(mutex_);
  if (!failure_.empty()) throw FileError(failure_);
  return result;
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
    note_losses();
    if (!ready_.put({std::move(*frame), number})) return 0;
    ++count;
  }
  return count;
}

void ReadAhead::note_losses() {
  std::map<std::string, std::uint64_t> losses = input_->losses();
  const std::lock_guard lock(mutex_);
  losses_ = std::move(losses);
}

// Said before the queue ends: who sees the end finds it.
void ReadAhead::end(const std::string& failure) {
  note_losses();
  {
    std::vector<std::string> problems = input_->problems();
    const std::lock_guard lock(mutex_);
    failure_ = failure;
    problems_ = std::move(problems);
  }
  ready_.end();
}

}  // namespace cleave::recording
