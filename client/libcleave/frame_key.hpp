// SPDX-License-Identifier: BSD-3-Clause
// What tells one frame from all others of its sensor.
#pragma once

#include <cstdint>

namespace cleave {

struct FrameKey {
  std::uint32_t epoch = 0;
  std::uint64_t frame_id = 0;
  bool operator==(const FrameKey&) const = default;
};

}  // namespace cleave
