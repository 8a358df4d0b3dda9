// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/evaluation/overlaps.hpp"

#include <map>
#include <utility>

namespace cleave::evaluation {
namespace {

using LabelPair = std::pair<std::uint32_t, std::uint16_t>;  // true, found

// Neighbouring points mostly have the same labels: one look into the map serves a whole run.
std::map<LabelPair, double> count_pairs(std::span<const std::uint32_t> truth,
                                        std::span<const std::uint16_t> found) {
  std::map<LabelPair, double> count;
  for (std::size_t begin = 0; begin < truth.size();) {
    std::size_t end = begin + 1;
    while (end < truth.size() && truth[end] == truth[begin] && found[end] == found[begin]) ++end;
    if (truth[begin] != 0) {
      count[{truth[begin], found[begin]}] += static_cast<double>(end - begin);
    }
    begin = end;
  }
  return count;
}

// Numbers the labels in their order, and lists them.
template <typename Label>
void number(std::map<Label, std::size_t>& labels, std::vector<Label>& list) {
  for (auto& [label, index] : labels) {
    index = list.size();
    list.push_back(label);
  }
}

}  // namespace

Overlaps count_overlaps(std::span<const std::uint32_t> truth,
                        std::span<const std::uint16_t> found) {
  const auto pairs = count_pairs(truth, found);
  std::map<std::uint32_t, std::size_t> rows;
  std::map<std::uint16_t, std::size_t> columns;
  for (const auto& [labels, points] : pairs) {
    rows.emplace(labels.first, 0);
    if (labels.second != 0) columns.emplace(labels.second, 0);
  }
  Overlaps o;
  number(rows, o.truth_label);
  number(columns, o.found_label);
  o.common.assign(rows.size(), std::vector<double>(columns.size(), 0));
  o.truth_size.assign(rows.size(), 0);
  o.found_size.assign(columns.size(), 0);
  for (const auto& [labels, points] : pairs) {
    const std::size_t row = rows.at(labels.first);
    o.points += points;
    o.truth_size[row] += points;
    if (labels.second == 0) continue;
    const std::size_t column = columns.at(labels.second);
    o.found_size[column] += points;
    o.common[row][column] += points;
  }
  return o;
}

}  // namespace cleave::evaluation
