// SPDX-License-Identifier: BSD-3-Clause
// Sets of numbers that are joined two at a time: components, pieces, segments.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace cleave::segmentation {

// The lowest member of a set is its root, whatever was joined in which order: labels that are made
// of roots depend on the sets alone. Reuses its memory.
class UnionFind {
 public:
  // So many numbers from 0 on, each a set of its own.
  void reset(std::size_t size) {
    parent_.resize(size);
    std::iota(parent_.begin(), parent_.end(), 0U);
  }
  // The same for `members`: all of their sets, or what is left of one would hang on what has gone.
  void isolate(std::span<const std::uint32_t> members) {
    for (const std::uint32_t member : members) parent_[member] = member;
  }
  // One number more, a set of its own. Returns it.
  std::uint32_t add() {
    parent_.push_back(static_cast<std::uint32_t>(parent_.size()));
    return parent_.back();
  }

  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }
  // Shortens the way there, so that the next is found sooner.
  [[nodiscard]] std::uint32_t root(std::uint32_t member) {
    while (parent_[member] != member) {
      parent_[member] = parent_[parent_[member]];
      member = parent_[member];
    }
    return member;
  }
  [[nodiscard]] std::size_t size() const { return parent_.size(); }

 private:
  std::vector<std::uint32_t> parent_;  // never above the member
};

}  // namespace cleave::segmentation
