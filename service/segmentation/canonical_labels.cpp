#include "segmentation/canonical_labels.hpp"

#include <algorithm>

namespace cleave::segmentation {

void LabelOrder::order(std::span<const PointRun> runs, std::size_t segments,
                       std::vector<std::uint16_t>& label_of_segment) {
  entries_.assign(segments, Entry{});
  for (std::uint32_t r = 0; r < runs.size(); ++r) {
    Entry& entry = entries_[runs[r].segment];
    if (entry.points == 0) {
      entry.first_run = r;
      entry.segment = runs[r].segment;
    }
    entry.points += runs[r].end - runs[r].begin;
  }
  std::sort(entries_.begin(), entries_.end(), [](const Entry& l, const Entry& r) {
    return l.points != r.points ? l.points > r.points : l.first_run < r.first_run;
  });

  label_of_segment.assign(segments, 0);
  for (std::size_t rank = 0; rank < segments && entries_[rank].points > 0; ++rank) {
    label_of_segment[entries_[rank].segment] =
        static_cast<std::uint16_t>(std::min(rank + 1, max_labels));
  }
}

}  // namespace cleave::segmentation
