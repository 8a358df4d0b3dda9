// SPDX-License-Identifier: BSD-3-Clause
// SIGTERM and SIGINT as a request that threads can wait for.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace cleave {

// RouDi asks who has joined it to end, too, when it ends, and again four times a second until they
// have: however often, that is one request.
//
// Construct before any other thread: it blocks both signals, and SIGUSR1 for its own use, for as
// long as the process lives, and threads inherit that. A signal after shutdown was requested, by a
// first one or by request(), ends the process at once (exit code 130).
class Shutdown {
 public:
  Shutdown();
  ~Shutdown();
  Shutdown(const Shutdown&) = delete;
  Shutdown& operator=(const Shutdown&) = delete;

  [[nodiscard]] bool requested() const { return requested_.load(); }
  // The RouDi that asked, if nobody else has; else 0.
  [[nodiscard]] pid_t roudi() const { return roudi_.load(); }
  // As if a signal had come: for programs that end by themselves. From any thread.
  void request();
  // Waits up to `timeout`; true if shutdown was requested.
  bool wait_for(std::chrono::milliseconds timeout);
  // Runs `action` once when shutdown is requested, on the signal's thread or the one that calls
  // request() (at once, on this one, if it has been already). Keep it short, e.g. WaitSet::wake.
  // Replaces the action set before.
  void on_request(std::function<void()> action);

 private:
  void watch();
  std::atomic<bool> requested_{false};
  std::atomic<pid_t> roudi_{0};
  std::atomic<bool> quit_{false};
  std::mutex mutex_;  // guards action_
  std::condition_variable changed_;
  std::function<void()> action_;
  std::thread thread_;
};

}  // namespace cleave
