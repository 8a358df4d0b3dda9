// SPDX-License-Identifier: BSD-3-Clause
// Results out in the order in which their frames came in, whoever finishes first.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

namespace cleave::service {

// Every frame draws a ticket when it comes in and hands it back once, with a result or without.
// Safe to use from several threads.
template <class Result>
class InOrderPublisher {
 public:
  using Ticket = std::uint64_t;

  // `publish` is called by whichever thread completes the order: one call at a time, in the order
  // of the tickets. It must not throw and must not come back here.
  // At most `capacity` tickets are out, so that a flood of frames that need no worker stays
  // bounded.
  InOrderPublisher(std::size_t capacity, std::function<void(Result&)> publish)
      : capacity_(capacity), publish_(std::move(publish)) {}

  // Waits while `capacity` tickets are out.
  [[nodiscard]] Ticket draw() {
    std::unique_lock lock(mutex_);
    room_.wait(lock, [&] { return outstanding_.size() < capacity_; });
    outstanding_.emplace(next_, std::nullopt);
    return next_++;
  }

  void complete(Ticket ticket, Result result) {
    std::unique_lock lock(mutex_);
    outstanding_.at(ticket) = std::move(result);
    publish_ready(lock);
  }

  // The frame has no result: those behind it do not wait for it.
  void skip(Ticket ticket) {
    std::unique_lock lock(mutex_);
    outstanding_.erase(ticket);
    publish_ready(lock);
    room_.notify_one();
  }

 private:
  // The lock is open during publish_: others hand in their results meanwhile, and this thread,
  // which looks again afterwards, publishes them too.
  void publish_ready(std::unique_lock<std::mutex>& lock) {
    if (publishing_) return;
    publishing_ = true;
    while (!outstanding_.empty() && outstanding_.begin()->second) {
      {
        Result result = std::move(*outstanding_.begin()->second);
        lock.unlock();
        publish_(result);
      }
      lock.lock();
      outstanding_.erase(outstanding_.begin());
      room_.notify_one();
    }
    publishing_ = false;
  }

  const std::size_t capacity_;
  const std::function<void(Result&)> publish_;
  std::mutex mutex_;                                     // guards the three below
  std::map<Ticket, std::optional<Result>> outstanding_;  // empty: not finished
  Ticket next_ = 0;
  bool publishing_ = false;
  std::condition_variable room_;
};

}  // namespace cleave::service
