// SPDX-License-Identifier: BSD-3-Clause
#include "console/segment_table.hpp"

#include <spdlog/fmt/fmt.h>

#include "console/table.hpp"

namespace cleave {
namespace {

using recording::Border;
using recording::BorderKind;
using recording::Segment;

std::string neighbours_of(const Segment& segment, const std::vector<Border>& borders) {
  std::string text;
  for (const Border& border : borders) {
    if (border.first != segment.label && border.second != segment.label) continue;
    const auto other = border.first == segment.label ? border.second : border.first;
    text += fmt::format("{}{}{}", text.empty() ? "" : " ", other,
                        border.kind == BorderKind::convex ? "+" : "");
  }
  return text;
}

}  // namespace

std::string segment_table(const recording::SegmentList& list) {
  Table table({{"label", Align::right},
               {"points", Align::right},
               {"centroid [m]", Align::right},
               {"box [m]", Align::right},
               {"planarity", Align::right},
               {"touches (+ convex)", Align::left}});
  for (const Segment& s : list.segments) {
    table.add_row(
        {fmt::format("{}", s.label), fmt::format("{}", s.point_count),
         fmt::format("{:.3f} {:.3f} {:.3f}", s.centroid.x, s.centroid.y, s.centroid.z),
         fmt::format("{:.3f} x {:.3f} x {:.3f}", s.box.extent.x, s.box.extent.y, s.box.extent.z),
         fmt::format("{:.2f}", s.planarity), neighbours_of(s, list.borders)});
  }
  return table.to_string();
}

}  // namespace cleave
