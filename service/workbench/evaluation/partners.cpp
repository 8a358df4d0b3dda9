// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/evaluation/partners.hpp"

#include <map>
#include <stdexcept>
#include <string>

#include "workbench/evaluation/assignment.hpp"

namespace cleave::evaluation {
namespace {

std::vector<std::vector<double>> transposed(const std::vector<std::vector<double>>& matrix) {
  std::vector<std::vector<double>> result(matrix.front().size());
  for (const auto& row : matrix) {
    for (std::size_t c = 0; c < row.size(); ++c) result[c].push_back(row[c]);
  }
  return result;
}

}  // namespace

std::vector<std::size_t> partners(const Overlaps& overlaps) {
  const auto& common = overlaps.common;
  std::vector<std::size_t> result(overlaps.true_segments(), no_partner);
  if (overlaps.true_segments() == 0 || overlaps.found_segments() == 0) return result;
  const bool upright = overlaps.true_segments() <= overlaps.found_segments();
  const auto assigned = best_assignment(upright ? common : transposed(common));
  for (std::size_t i = 0; i < assigned.size(); ++i) {
    const std::size_t row = upright ? i : assigned[i];
    const std::size_t column = upright ? assigned[i] : i;
    if (common[row][column] > 0) result[row] = column;
  }
  return result;
}

PairedLabels pair_labels(std::span<const std::uint32_t> truth,
                         std::span<const std::uint16_t> found) {
  const Overlaps overlaps = count_overlaps(truth, found);
  if (overlaps.true_segments() + overlaps.found_segments() > 0xFFFF) {
    throw std::runtime_error("there are " + std::to_string(overlaps.true_segments()) +
                             " true and " + std::to_string(overlaps.found_segments()) +
                             " found segments, more than can be numbered together (65535)");
  }
  std::map<std::uint32_t, std::uint16_t> number_of_truth = {{0, 0}};
  std::map<std::uint16_t, std::uint16_t> number_of_found = {{0, 0}};
  const std::vector<std::size_t> partner = partners(overlaps);
  std::uint16_t next = 1;
  for (std::size_t row = 0; row < partner.size(); ++row, ++next) {
    number_of_truth[overlaps.truth_label[row]] = next;
    if (partner[row] != no_partner) number_of_found[overlaps.found_label[partner[row]]] = next;
  }
  for (const std::uint16_t label : overlaps.found_label) {
    if (number_of_found.emplace(label, next).second) ++next;
  }

  PairedLabels paired;
  paired.truth.reserve(truth.size());
  paired.found.reserve(found.size());
  for (const std::uint32_t label : truth) paired.truth.push_back(number_of_truth.at(label));
  for (const std::uint16_t label : found) {
    const auto known = number_of_found.find(label);
    paired.found.push_back(known == number_of_found.end() ? std::uint16_t{0} : known->second);
  }
  return paired;
}

}  // namespace cleave::evaluation
