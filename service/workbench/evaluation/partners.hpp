// SPDX-License-Identifier: BSD-3-Clause
// Which found segment stands for which true one (section 5.2.2).
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "workbench/evaluation/overlaps.hpp"

namespace cleave::evaluation {

inline constexpr std::size_t no_partner = std::numeric_limits<std::size_t>::max();

// The one-to-one assignment with the most points in common: the column of every row, or no_partner.
// Partners have at least one point in common.
[[nodiscard]] std::vector<std::size_t> partners(const Overlaps& overlaps);

// Both sides numbered anew, so that partners have the same number: true segments from 1 on, in the
// order of their labels, then the found ones without a partner. 0 stays 0. A point is labelled
// rightly where both numbers are the same and not 0.
struct PairedLabels {
  std::vector<std::uint16_t> truth, found;
};
// One true and one found label a point. Found segments without a point that has a true label get
// 0: nothing is known of them. Throws std::runtime_error for more segments than labels can number.
[[nodiscard]] PairedLabels pair_labels(std::span<const std::uint32_t> truth,
                                       std::span<const std::uint16_t> found);

}  // namespace cleave::evaluation
