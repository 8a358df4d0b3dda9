// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/clean_up/canonical_labels.hpp"

#include <algorithm>

#include "segmentation/math/no_index.hpp"

namespace cleave::segmentation {

bool LabelOrder::order(std::span<const PointRun> runs, const std::vector<std::uint32_t>& settled,
                       std::vector<std::uint16_t>& label_of_segment) {
  entries_.assign(settled.size(), Entry{});
  for (std::uint32_t r = 0; r < runs.size(); ++r) {
    const std::uint32_t segment = settled[runs[r].segment];
    if (segment == no_index) continue;
    Entry& entry = entries_[segment];
    if (entry.points == 0) {
      entry.first_run = r;
      entry.segment = segment;
    }
    entry.points += runs[r].end - runs[r].begin;
  }
  std::sort(entries_.begin(), entries_.end(), [](const Entry& l, const Entry& r) {
    return l.points != r.points ? l.points > r.points : l.first_run < r.first_run;
  });

  label_of_segment.assign(settled.size(), 0);
  if (entries_.size() > max_labels && entries_[max_labels].points > 0) return false;
  for (std::size_t rank = 0; rank < entries_.size() && entries_[rank].points > 0; ++rank) {
    label_of_segment[entries_[rank].segment] = static_cast<std::uint16_t>(rank + 1);
  }
  for (std::size_t s = 0; s < settled.size(); ++s) {
    if (settled[s] != no_index) label_of_segment[s] = label_of_segment[settled[s]];
  }
  return true;
}

}  // namespace cleave::segmentation
