// SPDX-License-Identifier: BSD-3-Clause
// From a thread that makes things ahead of need to the one that needs them.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <utility>

namespace cleave::recording {

// One thread puts, one takes, in the order of putting.
template <class Item>
class AheadQueue {
 public:
  // At most `capacity` (> 0) things wait.
  explicit AheadQueue(std::size_t capacity) : capacity_(capacity) {}

  // Waits for room. False, and the item is gone: stop() was called.
  [[nodiscard]] bool put(Item item) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return waiting_.size() < capacity_ || stopped_; });
    if (stopped_) return false;
    waiting_.push_back(std::move(item));
    changed_.notify_all();
    return true;
  }

  // Nothing more comes; what waits is still handed out.
  void end() {
    const std::lock_guard lock(mutex_);
    ended_ = true;
    changed_.notify_all();
  }

  enum class Result { item, timeout, end };
  [[nodiscard]] Result take(std::chrono::milliseconds timeout, Item& item) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, timeout, [this] { return !waiting_.empty() || ended_; });
    if (waiting_.empty()) return ended_ ? Result::end : Result::timeout;
    item = std::move(waiting_.front());
    waiting_.pop_front();
    changed_.notify_all();
    return Result::item;
  }

  // Waits until there is something to take; false: it ended before.
  [[nodiscard]] bool wait_for_one() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !waiting_.empty() || ended_; });
    return !waiting_.empty();
  }

  // Nothing more is wanted: put() returns.
  void stop() {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
    changed_.notify_all();
  }

 private:
  const std::size_t capacity_;
  std::mutex mutex_;  // guards the three below
  std::deque<Item> waiting_;
  bool ended_ = false;
  bool stopped_ = false;
  std::condition_variable changed_;
};

}  // namespace cleave::recording
