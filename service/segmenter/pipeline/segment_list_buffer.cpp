// SPDX-License-Identifier: BSD-3-Clause
#include "segmenter/pipeline/segment_list_buffer.hpp"

#include "contract/segment_fields.hpp"
#include "libcleave/sequence.hpp"

namespace cleave::service {
namespace {

using segmentation::BorderKind;
static_assert(static_cast<int>(BorderKind::concave) == cleave_v1_BORDER_CONCAVE);
static_assert(static_cast<int>(BorderKind::convex) == cleave_v1_BORDER_CONVEX);

// Without memory of its own once the messages have been as many.
template <class Part, class Message>
void copy(const std::vector<Part>& parts, std::vector<Message>& messages) {
  messages.resize(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) copy_fields(parts[i], messages[i]);
}

}  // namespace

void SegmentListBuffer::fill(const segmentation::Segmentation& segmentation) {
  copy(segmentation.segments, segments_);
  copy(segmentation.borders, borders_);
  lend(list_.segments, segments_);
  lend(list_.borders, borders_);
}

}  // namespace cleave::service
