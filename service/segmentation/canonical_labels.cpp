#include "segmentation/canonical_labels.hpp"

#include <algorithm>

namespace cleave::segmentation {

void LabelOrder::order(const std::vector<std::uint32_t>& segment_of_point, std::size_t segments,
                       std::vector<std::uint16_t>& label_of_segment) {
  entries_.assign(segments, Entry{});
  const auto points = static_cast<std::uint32_t>(segment_of_point.size());
  for (std::uint32_t i = 0; i < points;) {
    const std::uint32_t segment = segment_of_point[i];
    const std::uint32_t begin = i;
    while (i < points && segment_of_point[i] == segment) ++i;
    Entry& entry = entries_[segment];
    if (entry.points == 0) {
      entry.first_point = begin;
      entry.segment = segment;
    }
    entry.points += i - begin;
  }
  std::sort(entries_.begin(), entries_.end(), [](const Entry& l, const Entry& r) {
    return l.points != r.points ? l.points > r.points : l.first_point < r.first_point;
  });

  label_of_segment.assign(segments, 0);
  for (std::size_t rank = 0; rank < segments && entries_[rank].points > 0; ++rank) {
    label_of_segment[entries_[rank].segment] =
        static_cast<std::uint16_t>(std::min(rank + 1, max_labels));
  }
}

}  // namespace cleave::segmentation
