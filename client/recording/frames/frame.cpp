// SPDX-License-Identifier: BSD-3-Clause
#include "recording/frames/frame.hpp"

#include <array>

namespace cleave::recording {

const char* name_of(BorderKind kind) {
  return kind == BorderKind::convex ? "convex" : "concave";
}

const char* name_of(FrameOutcome outcome) {
  static constexpr std::array names = {
      "segmented",           "bad size",          "bad header", "no finite point",
      "segmentation failed", "too many segments", "wrong unit"};
  const auto i = static_cast<std::size_t>(outcome);
  return i < names.size() ? names.at(i) : "unknown";
}

}  // namespace cleave::recording
