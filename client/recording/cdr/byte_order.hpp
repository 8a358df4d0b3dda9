// SPDX-License-Identifier: BSD-3-Clause
// Numbers of the other byte order.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

namespace cleave::recording {

template <class Number>
[[nodiscard]] Number byte_swapped(Number value) {
  auto bytes = std::bit_cast<std::array<std::byte, sizeof(Number)>>(value);
  std::ranges::reverse(bytes);
  return std::bit_cast<Number>(bytes);
}

}  // namespace cleave::recording
