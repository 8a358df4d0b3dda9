// SPDX-License-Identifier: BSD-3-Clause
// How large a cloud can be. Each array of the contract's bulk types has its size in the IDL.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace cleave {

// The largest image, and the points of a LargeDepthCloud and of a LargeLabelMap.
inline constexpr std::size_t capacity_columns = 1600;
inline constexpr std::size_t capacity_rows = 1200;
inline constexpr std::size_t capacity_points = capacity_columns * capacity_rows;

// Points of a DepthCloud and of a LabelMap.
inline constexpr std::size_t small_capacity_points = std::size_t{640} * 480;

// Whether a frame of so many points is of the large types.
[[nodiscard]] constexpr bool is_large(std::uint64_t points) {
  return points > small_capacity_points;
}

// "1600 x 1200", for people.
[[nodiscard]] inline std::string capacity_text() {
  return std::to_string(capacity_columns) + " x " + std::to_string(capacity_rows);
}

}  // namespace cleave
