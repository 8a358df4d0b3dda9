#include "cleave/recording/contract_frames.hpp"

#include <algorithm>
#include <span>
#include <string>

#include "recording/error.hpp"

namespace cleave::client {
namespace {

std::size_t checked_points(const FrameHeader& header) {
  const std::uint64_t points = point_count(header);
  if (points == 0 || points > capacity_points) {
    throw recording::DataError("a frame of " + std::to_string(header.width) + " x " +
                               std::to_string(header.height) + " points");
  }
  return static_cast<std::size_t>(points);
}

std::array<float, 3> array_of(const cleave_v1_Point& p) {
  return {p.x, p.y, p.z};
}

std::array<float, 3> array_of(const Eigen::Vector3f& v) {
  return {v.x(), v.y(), v.z()};
}

cleave_v1_Point point_of(const std::array<float, 3>& a) {
  return {a[0], a[1], a[2]};
}

recording::Segment frame_of(const SegmentMessage& m) {
  const cleave_v1_Quaternion& q = m.box.orientation;
  const cleave_v1_ImageRectangle& r = m.rectangle;
  return {m.label,
          m.point_count,
          array_of(m.centroid),
          array_of(m.mean_normal),
          array_of(m.box.centre),
          {q.x, q.y, q.z, q.w},
          array_of(m.box.extent),
          {r.left, r.top, r.right, r.bottom},
          m.planarity};
}

recording::Segment frame_of(const segmentation::Segment& s) {
  const Eigen::Quaternionf& q = s.box.orientation;
  const segmentation::ImageRectangle& r = s.rectangle;
  return {s.label,
          s.point_count,
          array_of(s.centroid),
          array_of(s.mean_normal),
          array_of(s.box.centre),
          {q.x(), q.y(), q.z(), q.w()},
          array_of(s.box.extent),
          {r.left, r.top, r.right, r.bottom},
          s.planarity};
}

SegmentMessage message_of(const recording::Segment& s) {
  const auto& q = s.box_orientation;
  const auto& r = s.rectangle;
  SegmentMessage m{};
  m.label = s.label;
  m.point_count = s.point_count;
  m.centroid = point_of(s.centroid);
  m.mean_normal = point_of(s.mean_normal);
  m.box = {point_of(s.box_centre), {q[0], q[1], q[2], q[3]}, point_of(s.box_extent)};
  m.rectangle = {r[0], r[1], r[2], r[3]};
  m.planarity = s.planarity;
  return m;
}

template <class Sequence, class Element>
void lend(Sequence& sequence, std::vector<Element>& elements) {
  sequence._length = static_cast<std::uint32_t>(elements.size());
  sequence._maximum = sequence._length;
  sequence._buffer = elements.data();
  sequence._release = false;
}

}  // namespace

recording::FrameHeader frame_of(const FrameHeader& h) {
  return {h.frame_id,
          h.epoch,
          h.capture_time_ns,
          h.arrival_time_ns,
          h.publication_time_ns,
          h.device_time_us,
          h.width,
          h.height,
          h.fx,
          h.fy,
          h.cx,
          h.cy,
          std::string(name_of(h.sensor)),
          std::string(name_of(h.coordinate_frame))};
}

recording::Cloud frame_of(const DepthCloud& cloud) {
  const float* const xyz = static_cast<const float*>(cloud.xyz);
  return {frame_of(cloud.header), {xyz, xyz + 3 * checked_points(cloud.header)}};
}

recording::Labels frame_of(const LabelMap& labels) {
  const std::uint16_t* const label = static_cast<const std::uint16_t*>(labels.label);
  return {frame_of(labels.header),
          labels.cloud_publication_time_ns,
          {label, label + checked_points(labels.header)}};
}

recording::SegmentList frame_of(const SegmentList& message) {
  recording::SegmentList list;
  list.header = frame_of(message.header);
  list.cloud_publication_time_ns = message.cloud_publication_time_ns;
  list.cloud_reception_time_ns = message.cloud_reception_time_ns;
  list.outcome = static_cast<std::uint32_t>(message.outcome);
  for (const SegmentMessage& s : std::span(message.segments._buffer, message.segments._length)) {
    list.segments.push_back(frame_of(s));
  }
  for (const BorderMessage& b : std::span(message.borders._buffer, message.borders._length)) {
    list.borders.push_back({b.first, b.second, b.kind == cleave_v1_BORDER_CONVEX});
  }
  list.queue_ms = message.queue_ms;
  list.segmentation_ms = message.segmentation_ms;
  return list;
}

void set_segments(recording::SegmentList& list, const segmentation::Segmentation& segmentation) {
  list.segments.clear();
  list.borders.clear();
  for (const auto& segment : segmentation.segments) list.segments.push_back(frame_of(segment));
  for (const auto& border : segmentation.borders) {
    list.borders.push_back(
        {border.first, border.second, border.kind == segmentation::BorderKind::convex});
  }
}

void fill(FrameHeader& m, const recording::FrameHeader& h) {
  m = {};
  m.frame_id = h.frame_id;
  m.epoch = h.epoch;
  m.capture_time_ns = h.capture_time_ns;
  m.arrival_time_ns = h.arrival_time_ns;
  m.publication_time_ns = h.publication_time_ns;
  m.device_time_us = h.device_time_us;
  m.width = h.width;
  m.height = h.height;
  m.fx = h.fx;
  m.fy = h.fy;
  m.cx = h.cx;
  m.cy = h.cy;
  if (!set_name(m.sensor, h.sensor) || !set_name(m.coordinate_frame, h.coordinate_frame)) {
    throw recording::DataError("a frame's sensor or coordinate frame has a name of more than 63");
  }
}

void fill(DepthCloud& message, const recording::Cloud& cloud) {
  fill(message.header, cloud.header);
  std::copy(cloud.xyz.begin(), cloud.xyz.end(), static_cast<float*>(message.xyz));
}

void fill(LabelMap& message, const recording::Labels& labels) {
  fill(message.header, labels.header);
  message.cloud_publication_time_ns = labels.cloud_publication_time_ns;
  std::copy(labels.label.begin(), labels.label.end(), static_cast<std::uint16_t*>(message.label));
}

SegmentListMessage::SegmentListMessage(const recording::SegmentList& list) {
  for (const recording::Segment& segment : list.segments) {
    segments_.push_back(message_of(segment));
  }
  for (const recording::Border& border : list.borders) {
    borders_.push_back({border.first, border.second,
                        border.convex ? cleave_v1_BORDER_CONVEX : cleave_v1_BORDER_CONCAVE});
  }
  fill(message_.header, list.header);
  message_.cloud_publication_time_ns = list.cloud_publication_time_ns;
  message_.cloud_reception_time_ns = list.cloud_reception_time_ns;
  message_.outcome = static_cast<cleave_v1_FrameOutcome>(list.outcome);
  lend(message_.segments, segments_);
  lend(message_.borders, borders_);
  message_.queue_ms = list.queue_ms;
  message_.segmentation_ms = list.segmentation_ms;
}

}  // namespace cleave::client
