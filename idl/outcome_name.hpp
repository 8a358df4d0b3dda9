// SPDX-License-Identifier: BSD-3-Clause
// The words for the contract's FrameOutcome, wherever one is told.
#pragma once

#include <array>
#include <cstdint>

namespace cleave {

// "segmented", "bad size", ...; "unknown".
[[nodiscard]] inline const char* outcome_name(std::uint32_t outcome) {
  constexpr std::array names = {
      "segmented",           "bad size",          "bad header", "no finite point",
      "segmentation failed", "too many segments", "wrong unit"};
  return outcome < names.size() ? names.at(outcome) : "unknown";
}

}  // namespace cleave
