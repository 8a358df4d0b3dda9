// SPDX-License-Identifier: BSD-3-Clause
// Who is next to whom, flat: compressed sparse rows.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace cleave::segmentation {

struct NeighbourLists {
  std::vector<std::uint32_t> begin;  // rows + 1; into `neighbour`
  std::vector<std::uint32_t> neighbour;

  [[nodiscard]] std::size_t size() const { return begin.empty() ? 0 : begin.size() - 1; }
  [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t row) const {
    return {neighbour.data() + begin[row], neighbour.data() + begin[row + 1]};
  }
};

}  // namespace cleave::segmentation
