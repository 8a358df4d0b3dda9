// SPDX-License-Identifier: BSD-3-Clause
// What was of no use, for messages.
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace cleave::sensor {

// "3 truncated, 1 wrong extension"; empty where nothing was lost.
[[nodiscard]] inline std::string text_of(const std::map<std::string, std::uint64_t>& unusable) {
  std::string text;
  for (const auto& [cause, count] : unusable) {
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + cause;
  }
  return text;
}

}  // namespace cleave::sensor
