// SPDX-License-Identifier: BSD-3-Clause
// The camera that an organised cloud was made with.
#pragma once

#include <cstdint>

#include "recording/cloud/projection.hpp"

namespace cleave::recording {

// The pinhole intrinsics that reproduce x and y of every finite point from its pixel and z within
// 1e-4 m, by least squares over all points; all 0 if there are none (unorganised, another
// projection, a transformed cloud, or fewer than 100 points).
// `xyz` holds width * height points, row-major. Deterministic.
[[nodiscard]] Intrinsics fit_intrinsics(const float* xyz, std::uint32_t width,
                                        std::uint32_t height);

}  // namespace cleave::recording
