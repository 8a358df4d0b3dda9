// SPDX-License-Identifier: BSD-3-Clause
// The true labels of an image: which pixels belong together as far as a camera can see.
#pragma once

#include <cstdint>
#include <vector>

#include "sensor/renderer/view/ray_cast.hpp"

namespace cleave::render {

// A label for each pixel (numbers as LabelledDepth says), 0 where nothing can be measured. Pixels
// of one surface are one part if they lie within 3 pixels and 3 % of their depth of each other.
// Parts of less than 120 pixels, and the smallest of a surface with more than ten, get label 0.
//
// Labels are those of the perfect image: a noisy frame's pixels inherit them, so that the truth
// about a static scene is the same in each of its frames.
[[nodiscard]] std::vector<std::uint16_t> label_visible_parts(const RayCast& rays);

}  // namespace cleave::render
