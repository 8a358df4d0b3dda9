// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/math/cell_ranking.hpp"

namespace cleave::segmentation {
namespace {
constexpr unsigned digit_bits = 11;
constexpr std::uint64_t digit_mask = (1U << digit_bits) - 1;
}  // namespace

void CellRanking::sort_by_digit(unsigned shift) {
  bucket_begin_.assign(digit_mask + 2, 0);
  for (const Item& item : items_) ++bucket_begin_[((item.key >> shift) & digit_mask) + 1];
  for (std::size_t d = 1; d < bucket_begin_.size(); ++d) bucket_begin_[d] += bucket_begin_[d - 1];
  sorted_.resize(items_.size());
  for (const Item& item : items_) {
    sorted_[bucket_begin_[(item.key >> shift) & digit_mask]++] = item;
  }
  items_.swap(sorted_);
}

void CellRanking::rank(std::span<const std::uint64_t> keys) {
  std::uint64_t differing_bits = 0;
  items_.resize(keys.size());
  for (std::uint32_t i = 0; i < keys.size(); ++i) {
    items_[i] = {keys[i], i};
    differing_bits |= keys[i] ^ keys[0];
  }
  for (unsigned shift = 0; shift < 64; shift += digit_bits) {
    if (((differing_bits >> shift) & digit_mask) != 0) sort_by_digit(shift);
  }

  distinct_.clear();
  rank_of_item_.resize(keys.size());
  for (const Item& item : items_) {
    if (distinct_.empty() || distinct_.back() != item.key) distinct_.push_back(item.key);
    rank_of_item_[item.index] = static_cast<std::uint32_t>(distinct_.size() - 1);
  }
}

}  // namespace cleave::segmentation
