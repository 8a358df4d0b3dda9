// SPDX-License-Identifier: BSD-3-Clause
// A scene without noise whose true segments are known: a table and two boxes that touch.
#pragma once

#include <cstdint>

#include "workbench/evaluation/labelled_cloud.hpp"

namespace cleave::tests {

// As a camera sees it that looks down at the table. Labels: 1 table, 2 the tall box, 3 the low one,
// which touches the tall one and stands out in front of it. The top rows see nothing: NaN, label 0.
[[nodiscard]] evaluation::LabelledCloud render_touching_boxes(std::uint32_t width = 320,
                                                              std::uint32_t height = 240);

}  // namespace cleave::tests
