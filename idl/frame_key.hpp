// SPDX-License-Identifier: BSD-3-Clause
// What tells one frame from all others of its sensor.
#pragma once

#include <compare>
#include <cstdint>

namespace cleave {

struct FrameKey {
  std::uint32_t epoch = 0;
  std::uint64_t frame_id = 0;
  auto operator<=>(const FrameKey&) const = default;
};

// Of the contract's FrameHeader, or of a struct that mirrors it.
template <class Header>
[[nodiscard]] FrameKey key_of(const Header& header) {
  return {header.epoch, header.frame_id};
}

}  // namespace cleave
