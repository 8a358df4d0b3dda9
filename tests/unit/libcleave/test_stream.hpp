// SPDX-License-Identifier: BSD-3-Clause
// A stream for tests that need no RouDi, out of the way of what else runs on the machine.
#pragma once

#include <unistd.h>

#include <chrono>
#include <string>
#include <thread>

#include "libcleave/stream.hpp"

namespace cleave::test {

inline StreamOptions network_options() {
  StreamOptions options;
  options.domain = 20 + static_cast<std::uint32_t>(::getpid()) % 60;
  options.shared_memory = false;
  return options;
}

inline std::string sensor_name() {
  return "t" + std::to_string(::getpid());
}

// Polls until `condition` holds; false after 10 s (the machine may be busy).
template <class Condition>
bool eventually(Condition condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

}  // namespace cleave::test
