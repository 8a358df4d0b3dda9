// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/cloud/recorded_segments.hpp"

#include <utility>

#include "console/contract_json.hpp"
#include "contract/segment_fields.hpp"

namespace cleave::workbench {
namespace {

using segmentation::BorderKind;
using Recorded = recording::BorderKind;
static_assert(static_cast<int>(BorderKind::concave) == static_cast<int>(Recorded::concave));
static_assert(static_cast<int>(BorderKind::convex) == static_cast<int>(Recorded::convex));

}  // namespace

void set_segments(recording::SegmentList& list, const segmentation::Segmentation& segmentation) {
  list.segments.clear();
  list.borders.clear();
  for (const auto& segment : segmentation.segments) {
    service::copy_fields(segment, list.segments.emplace_back());
  }
  for (const auto& border : segmentation.borders) {
    service::copy_fields(border, list.borders.emplace_back());
  }
}

Json segments_json(const segmentation::Segmentation& segmentation) {
  recording::SegmentList list;
  set_segments(list, segmentation);
  Json json = contract_json(list);
  return {{"segments", std::move(json["segments"])}, {"borders", std::move(json["borders"])}};
}

}  // namespace cleave::workbench
