// SPDX-License-Identifier: BSD-3-Clause
// From the fields x, y and z, of whatever type, to floats.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "recording/pcd/header.hpp"

namespace cleave::recording {

struct Coordinates {
  std::vector<float> xyz;          // 3 a point, relative to `origin`
  std::array<double, 3> origin{};  // in the file's coordinates
};

// `data`: points as the header describes them, without padding. The origin is 0 0 0, and the
// coordinates are the file's rounded to float, unless floats would lose what the points are about:
// doubles or large integers, farther from zero than eight times the cloud's own extent. Then the
// origin is near the cloud's middle (medians), of few enough bits that it is a float itself, and a
// point that the file has at 0 0 0, which by convention is no measurement, becomes NaN NaN NaN, for
// nobody could tell it any more. Deterministic.
[[nodiscard]] Coordinates coordinates_of(const PcdHeader& header,
                                         std::span<const std::uint8_t> data);

}  // namespace cleave::recording
