// SPDX-License-Identifier: BSD-3-Clause
// Integer grid coordinates in one sortable number.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace cleave::segmentation {

// Cell coordinates are cut to +-this, so that three of them fit into 64 bits whatever the extent of
// the cloud: at 6 mm it is 3.1 km from the origin. Points beyond share the outermost cells.
inline constexpr float max_cell = 524000;

// The cell that holds `coordinate`, in cells; any float but NaN.
[[nodiscard]] inline std::int32_t cell_of(float coordinate) {
  const float bounded = std::clamp(coordinate, -max_cell, max_cell);
  const auto truncated = static_cast<std::int32_t>(bounded);
  return truncated - static_cast<std::int32_t>(bounded < static_cast<float>(truncated));
}

// Keys sort by (z, y, x). Every axis has a free cell at both ends, so that a neighbour's key is a
// fixed offset away: dx + dy * stride_y + dz * stride_z.
struct CellPacking {
  std::array<std::int32_t, 3> origin = {0, 0, 0};
  std::uint64_t stride_y = 1;
  std::uint64_t stride_z = 1;

  // For the cells (x[i], y[i], z[i]); the spans have one size, not 0.
  [[nodiscard]] static CellPacking covering(std::span<const std::int32_t> x,
                                            std::span<const std::int32_t> y,
                                            std::span<const std::int32_t> z) {
    CellPacking packing;
    std::array<std::uint64_t, 2> width{};
    const std::array axes = {x, y, z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [low, high] = std::minmax_element(axes[axis].begin(), axes[axis].end());
      packing.origin[axis] = *low - 1;
      if (axis < 2) width[axis] = static_cast<std::uint64_t>(*high - *low) + 3;
    }
    packing.stride_y = width[0];
    packing.stride_z = width[0] * width[1];
    return packing;
  }

  [[nodiscard]] std::uint64_t key(std::int32_t x, std::int32_t y, std::int32_t z) const {
    return static_cast<std::uint64_t>(x - origin[0]) +
           static_cast<std::uint64_t>(y - origin[1]) * stride_y +
           static_cast<std::uint64_t>(z - origin[2]) * stride_z;
  }
};

}  // namespace cleave::segmentation
