// SPDX-License-Identifier: BSD-3-Clause
// Whether a result is one that anybody can have wanted.
#pragma once

#include <cstddef>
#include <string_view>

#include "segmentation/segmentation.hpp"

namespace cleave::segmentation {

enum class Doubt {
  none,
  mostly_unlabelled,    // most measured points have no segment
  mostly_single_points  // most segments are one point
};

inline constexpr std::size_t doubts = 3;  // with none

[[nodiscard]] Doubt doubt_about(const Segmentation& result);

// What was found, and which options to set; empty for none.
[[nodiscard]] std::string_view advice_on(Doubt doubt);

}  // namespace cleave::segmentation
