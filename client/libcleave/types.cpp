// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/types.hpp"

#include <algorithm>
#include <chrono>
#include <cstring>

namespace cleave {

std::string_view name_of(const char (&text)[64]) {
  const char* const end = std::find(std::begin(text), std::end(text), '\0');
  return end == std::end(text) ? std::string_view{} : std::string_view{text, end};
}

bool set_name(char (&text)[64], std::string_view name) {
  if (name.size() >= sizeof text) return false;
  std::memset(text, 0, sizeof text);  // no stale bytes of the pool leave the process
  std::copy(name.begin(), name.end(), text);
  return true;
}

std::int64_t monotonic_now_ns() {
  // libstdc++'s steady_clock is CLOCK_MONOTONIC, the same for every process of the machine.
  return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::int64_t wall_now_ns() {
  return std::chrono::nanoseconds(std::chrono::system_clock::now().time_since_epoch()).count();
}

}  // namespace cleave
