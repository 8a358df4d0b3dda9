// SPDX-License-Identifier: BSD-3-Clause
// Numbers the occupied cells of a grid without laying the grid out: its extent costs nothing.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace cleave::segmentation {

// Every key's place among the distinct keys in ascending order. Linear time: a radix sort over the
// bits that are in use.
class CellRanking {
 public:
  void rank(std::span<const std::uint64_t> keys);

  [[nodiscard]] const std::vector<std::uint64_t>& distinct_keys() const { return distinct_; }
  [[nodiscard]] const std::vector<std::uint32_t>& rank_of_item() const { return rank_of_item_; }

 private:
  struct Item {
    std::uint64_t key;
    std::uint32_t index;
  };
  void sort_by_digit(unsigned shift);

  std::vector<Item> items_, sorted_;
  std::vector<std::uint64_t> distinct_;
  std::vector<std::uint32_t> rank_of_item_;
  std::vector<std::uint32_t> bucket_begin_;
};

}  // namespace cleave::segmentation
