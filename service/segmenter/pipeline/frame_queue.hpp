// SPDX-License-Identifier: BSD-3-Clause
// Frames that wait for a worker, and the bound on those that workers have.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

namespace cleave::service {

enum class Mode {
  live,     // the newest frames count: a full queue drops its oldest
  lossless  // every frame counts: whoever pushes into a full queue waits
};

// One thread pushes, many take, in the order of pushing.
template <class Frame>
class FrameQueue {
 public:
  // Held from taking a frame until its results are out; its destruction lets the next one in.
  struct Leave {
    void operator()(FrameQueue* queue) const { queue->left_work(); }
  };
  using Place = std::unique_ptr<FrameQueue, Leave>;
  struct Taken {
    Frame frame;
    Place place;
  };

  // At most `capacity` (> 0) frames wait and at most `places` (> 0) are out with workers: each of
  // those holds a loan of the label maps' writer, which has few.
  FrameQueue(Mode mode, std::size_t capacity, std::size_t places)
      : mode_(mode), capacity_(capacity), places_(places) {}

  // Live: never blocks, and returns the oldest waiting frame if it had to make room. Not after
  // close().
  [[nodiscard]] std::optional<Frame> push(Frame frame) {
    std::unique_lock lock(mutex_);
    if (mode_ == Mode::lossless) room_.wait(lock, [&] { return waiting_.size() < capacity_; });
    std::optional<Frame> dropped;
    if (waiting_.size() == capacity_) {
      dropped = std::move(waiting_.front());
      waiting_.pop_front();
    }
    waiting_.push_back(std::move(frame));
    lock.unlock();
    work_.notify_one();
    return dropped;
  }

  // The oldest waiting frame; waits for one, and for a place. Empty once closed and drained.
  [[nodiscard]] std::optional<Taken> take() {
    std::unique_lock lock(mutex_);
    work_.wait(lock, [&] { return waiting_.empty() ? closed_ : in_work_ < places_; });
    if (waiting_.empty()) return std::nullopt;
    ++in_work_;
    Taken taken{std::move(waiting_.front()), Place(this)};
    waiting_.pop_front();
    lock.unlock();
    room_.notify_one();
    return taken;
  }

  // No more frames come; those that wait are still handed out.
  void close() {
    {
      const std::lock_guard lock(mutex_);
      closed_ = true;
    }
    work_.notify_all();
  }

 private:
  void left_work() {
    {
      const std::lock_guard lock(mutex_);
      --in_work_;
    }
    work_.notify_all();  // all: after close() every waiting thread has to see the end
  }

  const Mode mode_;
  const std::size_t capacity_;
  const std::size_t places_;
  std::mutex mutex_;  // guards the three below
  std::deque<Frame> waiting_;
  std::size_t in_work_ = 0;
  bool closed_ = false;
  std::condition_variable work_;  // a frame and a place for it, or closed
  std::condition_variable room_;  // room in the queue
};

}  // namespace cleave::service
