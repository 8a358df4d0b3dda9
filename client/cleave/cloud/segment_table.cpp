#include "cleave/cloud/segment_table.hpp"

#include <spdlog/fmt/fmt.h>

#include <utility>

#include "cleave/console/table.hpp"

namespace cleave::client {
namespace {

using segmentation::Border;
using segmentation::BorderKind;
using segmentation::Segment;

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

Json json_of(const Eigen::Vector3f& v) {
  return {decimal(v.x()), decimal(v.y()), decimal(v.z())};
}

}  // namespace

std::string segment_table(const segmentation::Segmentation& segmentation) {
  Table table({{"label", Align::right},
               {"points", Align::right},
               {"centroid [m]", Align::right},
               {"box [m]", Align::right},
               {"planarity", Align::right},
               {"touches (+ convex)", Align::left}});
  for (const Segment& s : segmentation.segments) {
    table.add_row(
        {fmt::format("{}", s.label), fmt::format("{}", s.point_count),
         fmt::format("{:.3f} {:.3f} {:.3f}", s.centroid.x(), s.centroid.y(), s.centroid.z()),
         fmt::format("{:.3f} x {:.3f} x {:.3f}", s.box.extent.x(), s.box.extent.y(),
                     s.box.extent.z()),
         fmt::format("{:.2f}", s.planarity), neighbours_of(s, segmentation.borders)});
  }
  return table.to_string();
}

Json json_of(const Segment& s) {
  const Eigen::Quaternionf& q = s.box.orientation;
  return {{"label", s.label},
          {"point_count", s.point_count},
          {"centroid", json_of(s.centroid)},
          {"mean_normal", json_of(s.mean_normal)},
          {"box",
           {{"centre", json_of(s.box.centre)},
            {"orientation", {decimal(q.x()), decimal(q.y()), decimal(q.z()), decimal(q.w())}},
            {"extent", json_of(s.box.extent)}}},
          {"rectangle",
           {{"left", s.rectangle.left},
            {"top", s.rectangle.top},
            {"right", s.rectangle.right},
            {"bottom", s.rectangle.bottom}}},
          {"planarity", decimal(s.planarity)}};
}

Json json_of(const Border& border) {
  return {{"first", border.first},
          {"second", border.second},
          {"kind", border.kind == BorderKind::convex ? "convex" : "concave"}};
}

Json json_of(const segmentation::Segmentation& segmentation) {
  Json segments = Json::array();
  for (const Segment& segment : segmentation.segments) segments.push_back(json_of(segment));
  Json borders = Json::array();
  for (const Border& border : segmentation.borders) borders.push_back(json_of(border));
  return {{"segments", std::move(segments)}, {"borders", std::move(borders)}};
}

}  // namespace cleave::client
