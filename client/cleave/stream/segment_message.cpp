#include "cleave/stream/segment_message.hpp"

#include <spdlog/fmt/fmt.h>

#include <array>
#include <span>

#include "cleave/cloud/segment_table.hpp"
#include "cleave/console/table.hpp"

namespace cleave::client {
namespace {

using segmentation::Border;
using segmentation::BorderKind;
using segmentation::Segment;
using segmentation::Segmentation;

Eigen::Vector3f vector_of(const cleave_v1_Point& p) {
  return {p.x, p.y, p.z};
}

Segment segment_of(const SegmentMessage& m) {
  const cleave_v1_Quaternion& q = m.box.orientation;
  return {.label = m.label,
          .point_count = m.point_count,
          .centroid = vector_of(m.centroid),
          .mean_normal = vector_of(m.mean_normal),
          .box = {.centre = vector_of(m.box.centre),
                  .orientation = Eigen::Quaternionf(q.w, q.x, q.y, q.z),
                  .extent = vector_of(m.box.extent)},
          .rectangle = {m.rectangle.left, m.rectangle.top, m.rectangle.right, m.rectangle.bottom},
          .planarity = m.planarity};
}

Border border_of(const BorderMessage& m) {
  return {m.first, m.second,
          m.kind == cleave_v1_BORDER_CONVEX ? BorderKind::convex : BorderKind::concave};
}

Json header_json(const FrameHeader& h) {
  return {{"frame_id", h.frame_id},
          {"epoch", h.epoch},
          {"capture_time_ns", h.capture_time_ns},
          {"arrival_time_ns", h.arrival_time_ns},
          {"publication_time_ns", h.publication_time_ns},
          {"device_time_us", h.device_time_us},
          {"width", h.width},
          {"height", h.height},
          {"fx", decimal(h.fx)},
          {"fy", decimal(h.fy)},
          {"cx", decimal(h.cx)},
          {"cy", decimal(h.cy)},
          {"sensor", name_of(h.sensor)},
          {"coordinate_frame", name_of(h.coordinate_frame)}};
}

template <class T>
Json array_of(const std::vector<T>& items) {
  Json array = Json::array();
  for (const T& item : items) array.push_back(json_of(item));
  return array;
}

}  // namespace

Segmentation segmentation_of(const SegmentList& list) {
  Segmentation result;
  for (const SegmentMessage& m : std::span(list.segments._buffer, list.segments._length)) {
    result.segments.push_back(segment_of(m));
  }
  for (const BorderMessage& m : std::span(list.borders._buffer, list.borders._length)) {
    result.borders.push_back(border_of(m));
  }
  return result;
}

const char* outcome_of(const SegmentList& list) {
  static constexpr std::array names = {
      "segmented",           "bad size",          "bad header", "no finite point",
      "segmentation failed", "too many segments", "wrong unit"};
  const auto i = static_cast<std::size_t>(list.outcome);
  return i < names.size() ? names.at(i) : "unknown";
}

std::string text_of(const SegmentList& list) {
  const FrameHeader& h = list.header;
  constexpr double ns_per_s = 1e9;
  std::string text = fmt::format(
      "frame {}  epoch {}  sensor {}  {} x {} points  in {}  captured at {:.3f} s\n", h.frame_id,
      h.epoch, printable(name_of(h.sensor)), h.width, h.height,
      printable(name_of(h.coordinate_frame)), static_cast<double>(h.capture_time_ns) / ns_per_s);
  if (list.outcome != cleave_v1_OUTCOME_SEGMENTED) {
    return text + fmt::format("rejected: {}\n\n", outcome_of(list));
  }
  text +=
      fmt::format("segmented: {} segments, {} borders  waited {:.1f} ms, took {:.1f} ms\n",
                  list.segments._length, list.borders._length, list.queue_ms, list.segmentation_ms);
  return text + segment_table(segmentation_of(list)) + '\n';
}

Json json_of(const SegmentList& list) {
  const Segmentation segmentation = segmentation_of(list);
  return {{"header", header_json(list.header)},
          {"cloud_publication_time_ns", list.cloud_publication_time_ns},
          {"cloud_reception_time_ns", list.cloud_reception_time_ns},
          {"outcome", outcome_of(list)},
          {"segments", array_of(segmentation.segments)},
          {"borders", array_of(segmentation.borders)},
          {"queue_ms", decimal(list.queue_ms)},
          {"segmentation_ms", decimal(list.segmentation_ms)}};
}

}  // namespace cleave::client
