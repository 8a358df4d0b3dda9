// SPDX-License-Identifier: BSD-3-Clause
// Numbers that people write on command lines.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace cleave::workbench {

// Empty unless all of the text is one number that fits.
template <class Number>
[[nodiscard]] std::optional<Number> parse_number(std::string_view text) {
  Number value{};
  const auto [stopped, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stopped != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace cleave::workbench
