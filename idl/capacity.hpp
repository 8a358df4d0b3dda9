// SPDX-License-Identifier: BSD-3-Clause
// How large a cloud can be.
#pragma once

#include <cstddef>

namespace cleave {

// Points of a DepthCloud and of a LabelMap, whose arrays have this size in the IDL.
inline constexpr std::size_t capacity_points = std::size_t{640} * 480;

}  // namespace cleave
