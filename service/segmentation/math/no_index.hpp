// SPDX-License-Identifier: BSD-3-Clause
// What stands in a list of indices where there is nothing.
#pragma once

#include <cstdint>
#include <limits>

namespace cleave::segmentation {

inline constexpr std::uint32_t no_index = std::numeric_limits<std::uint32_t>::max();

}  // namespace cleave::segmentation
