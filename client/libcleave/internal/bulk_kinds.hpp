// SPDX-License-Identifier: BSD-3-Clause
// The two kinds of bulk sample, each a small type and a large one that differ in room alone.
#pragma once

#include <cstddef>
#include <cstdint>

#include "libcleave/types.hpp"

namespace cleave {

struct CloudKind {
  using Small = DepthCloud;
  using Large = LargeDepthCloud;
  using Value = float;
  static constexpr std::size_t values_a_point = 3;
  static constexpr std::size_t offset = offsetof(DepthCloud, xyz);
  static_assert(offset == offsetof(LargeDepthCloud, xyz));
};

struct LabelKind {
  using Small = LabelMap;
  using Large = LargeLabelMap;
  using Value = std::uint16_t;
  static constexpr std::size_t values_a_point = 1;
  static constexpr std::size_t offset = offsetof(LabelMap, label);
  static_assert(offset == offsetof(LargeLabelMap, label));
  static_assert(offsetof(LabelMap, cloud_publication_time_ns) ==
                offsetof(LargeLabelMap, cloud_publication_time_ns));
};

// Points that a sample has room for.
[[nodiscard]] constexpr std::size_t capacity_of(bool large) {
  return large ? capacity_points : small_capacity_points;
}

}  // namespace cleave
