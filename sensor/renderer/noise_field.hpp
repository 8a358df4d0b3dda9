// SPDX-License-Identifier: BSD-3-Clause
// Images of correlated noise.
#pragma once

#include <cstdint>
#include <vector>

#include "sensor/renderer/scene/random.hpp"

namespace cleave::render {

// Row-major width x height values, scaled to a root mean square of 1, close to normal: white noise
// after three box filters of (2 radius + 1)^2 pixels, a correlation of almost Gaussian shape with
// sigma^2 = radius (radius + 1). Radius 0 = white noise. The image wraps around at its borders.
// Throws std::invalid_argument if a box would not fit into the image.
[[nodiscard]] std::vector<float> noise_field(Random& random, std::uint32_t width,
                                             std::uint32_t height, std::uint32_t radius);

}  // namespace cleave::render
