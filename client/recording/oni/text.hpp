// SPDX-License-Identifier: BSD-3-Clause
// Texts as .oni files hold them.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "recording/mcap/bytes.hpp"

namespace cleave::oni {

// A length of 4 bytes, and so many characters of which the last ones are zeros. Empty where too few
// bytes are left.
[[nodiscard]] inline std::optional<std::string_view> take_text(recording::ByteSource& bytes) {
  const auto length = bytes.try_number<std::uint32_t>();
  if (!length) return std::nullopt;
  const auto text = bytes.try_take(*length);
  if (!text) return std::nullopt;
  const std::string_view whole(reinterpret_cast<const char*>(text->data()), text->size());
  return whole.substr(0, whole.find('\0'));
}

}  // namespace cleave::oni
