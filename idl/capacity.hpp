// SPDX-License-Identifier: BSD-3-Clause
// How large a cloud can be.
#pragma once

#include <cstddef>
#include <string>

namespace cleave {

// The largest image.
inline constexpr std::size_t capacity_columns = 640;
inline constexpr std::size_t capacity_rows = 480;

// Points of a DepthCloud and of a LabelMap, whose arrays have this size in the IDL.
inline constexpr std::size_t capacity_points = capacity_columns * capacity_rows;

// "640 x 480", for people.
[[nodiscard]] inline std::string capacity_text() {
  return std::to_string(capacity_columns) + " x " + std::to_string(capacity_rows);
}

}  // namespace cleave
