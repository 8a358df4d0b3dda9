// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/process/shutdown.hpp"

#include <pthread.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <string>

#include "libcleave/process/roudi_process.hpp"

namespace cleave {
namespace {

sigset_t shutdown_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGUSR1);  // the destructor's way to end the thread
  return signals;
}

}  // namespace

Shutdown::Shutdown() {
  const sigset_t signals = shutdown_signals();
  if (const int code = pthread_sigmask(SIG_BLOCK, &signals, nullptr); code != 0) {
    throw std::runtime_error(std::string("cannot block signals: ") + std::strerror(code));
  }
  thread_ = std::thread([this] { watch(); });
}

Shutdown::~Shutdown() {
  quit_ = true;
  pthread_kill(thread_.native_handle(), SIGUSR1);
  thread_.join();
}

void Shutdown::watch() {
  const sigset_t signals = shutdown_signals();
  while (!quit_) {
    siginfo_t info{};
    const int signal = sigwaitinfo(&signals, &info);
    if (signal != SIGINT && signal != SIGTERM) continue;
    if (info.si_code == SI_USER && is_roudi(info.si_pid)) {
      if (!requested_) roudi_ = info.si_pid;
      request();
      continue;
    }
    // Asked twice: do not wait for the drain.
    if (requested_ && roudi_.exchange(0) == 0) _exit(130);
    request();
  }
}

void Shutdown::request() {
  std::function<void()> action;
  {
    const std::lock_guard lock(mutex_);
    if (requested_.exchange(true)) return;
    action = action_;
  }
  changed_.notify_all();
  if (action) action();
}

bool Shutdown::wait_for(std::chrono::milliseconds timeout) {
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, timeout, [this] { return requested_.load(); });
}

void Shutdown::on_request(std::function<void()> action) {
  {
    const std::lock_guard lock(mutex_);
    action_ = std::move(action);
    if (!requested_) return;
    action = action_;
  }
  if (action) action();
}

}  // namespace cleave
