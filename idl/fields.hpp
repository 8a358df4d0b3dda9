// SPDX-License-Identifier: BSD-3-Clause
// The fields of the contract's types, each list once. Bytes, JSON, conversions: whatever goes
// through a type visits its list, so that a new field is a line in the IDL, a member of each struct
// that mirrors the type, and a line here. tests/unit/idl holds the lists against the IDL.
//
// A list is called with a visitor and one struct or several that mirror the type, member by member
// of the same names. It visits the fields in the IDL's order:
//   visit.number(name, value...)      a number
//   visit.choice(name, value...)      an enumeration
//   visit.text(name, value...)        a text
//   visit.group(name, list, value...) another type of the contract, with its list
//   visit.each(name, list, value...)  a sequence of these
// Each list names its type.
#pragma once

namespace cleave::fields {

struct PointFields {
  static constexpr const char* type = "Point";

  template <class Visit, class... S>
  void operator()(Visit&& visit, S&... s) const {
    visit.number("x", s.x...);
    visit.number("y", s.y...);
    visit.number("z", s.z...);
  }
};
inline constexpr PointFields point;

struct QuaternionFields {
  static constexpr const char* type = "Quaternion";

  template <class Visit, class... S>
  void operator()(Visit&& visit, S&... s) const {
    visit.number("x", s.x...);
    visit.number("y", s.y...);
    visit.number("z", s.z...);
    visit.number("w", s.w...);
  }
};
inline constexpr QuaternionFields quaternion;

struct PoseFields {
  static constexpr const char* type = "Pose3";

  template <class Visit, class... S>
  void operator()(Visit&& visit, S&... s) const {
    visit.group("position", point, s.position...);
    visit.group("orientation", quaternion, s.orientation...);
  }
};
inline constexpr PoseFields pose;

struct HeaderFields {
  static constexpr const char* type = "FrameHeader";

  template <class Visit, class... S>
  void operator()(Visit&& visit, S&... s) const {
    visit.number("frame_id", s.frame_id...);
    visit.number("epoch", s.epoch...);
    visit.number("capture_time_ns", s.capture_time_ns...);
    visit.number("arrival_time_ns", s.arrival_time_ns...);
    visit.number("publication_time_ns", s.publication_time_ns...);
    visit.number("device_time_us", s.device_time_us...);
    visit.number("width", s.width...);
    visit.number("height", s.height...);
    visit.number("fx", s.fx...);
    visit.number("fy", s.fy...);
    visit.number("cx", s.cx...);
    visit.number("cy", s.cy...);
    visit.text("sensor", s.sensor...);
    visit.text("coordinate_frame", s.coordinate_frame...);
    visit.text("parent_frame", s.parent_frame...);
    visit.group("pose", pose, s.pose...);
  }
};
inline constexpr HeaderFields header;

struct ImageRectangleFields {
  static constexpr const char* type = "ImageRectangle";

  template <class Visit, class... S>
  void operator()(Visit&& visit, S&... s) const {
    visit.number("left", s.left...);
    visit.number("top", s.top...);
    visit.number("right", s.right...);
    visit.number("bottom", s.bottom...);
  }
};
inline constexpr ImageRectangleFields image_rectangle;

struct OrientedBoxFields {
  static constexpr const char* type = "OrientedBox";

  template <class Visit, class... S>
  void operator()(Visit&& visit, S&... s) const {
    visit.group("centre", point, s.centre...);
    visit.group("orientation", quaternion, s.orientation...);
    visit.group("extent", point, s.extent...);
  }
};
inline constexpr OrientedBoxFields oriented_box;

struct SegmentFields {
  static constexpr const char* type = "Segment";

  template <class Visit, class... S>
  void operator()(Visit&& visit, S&... s) const {
    visit.number("label", s.label...);
    visit.number("point_count", s.point_count...);
    visit.group("centroid", point, s.centroid...);
    visit.group("mean_normal", point, s.mean_normal...);
    visit.group("box", oriented_box, s.box...);
    visit.group("rectangle", image_rectangle, s.rectangle...);
    visit.number("planarity", s.planarity...);
  }
};
inline constexpr SegmentFields segment;

struct BorderFields {
  static constexpr const char* type = "Border";

  template <class Visit, class... S>
  void operator()(Visit&& visit, S&... s) const {
    visit.number("first", s.first...);
    visit.number("second", s.second...);
    visit.choice("kind", s.kind...);
  }
};
inline constexpr BorderFields border;

struct SegmentListFields {
  static constexpr const char* type = "SegmentList";

  template <class Visit, class... S>
  void operator()(Visit&& visit, S&... s) const {
    visit.group("header", header, s.header...);
    visit.number("cloud_publication_time_ns", s.cloud_publication_time_ns...);
    visit.number("cloud_reception_time_ns", s.cloud_reception_time_ns...);
    visit.choice("outcome", s.outcome...);
    visit.each("segments", segment, s.segments...);
    visit.each("borders", border, s.borders...);
    visit.number("queue_ms", s.queue_ms...);
    visit.number("segmentation_ms", s.segmentation_ms...);
  }
};
inline constexpr SegmentListFields segment_list;

struct CauseCountFields {
  static constexpr const char* type = "CauseCount";

  template <class Visit, class... S>
  void operator()(Visit&& visit, S&... s) const {
    visit.text("cause", s.cause...);
    visit.number("count", s.count...);
  }
};
inline constexpr CauseCountFields cause_count;

struct NodeStatusFields {
  static constexpr const char* type = "NodeStatus";

  template <class Visit, class... S>
  void operator()(Visit&& visit, S&... s) const {
    visit.text("node", s.node...);
    visit.text("version", s.version...);
    visit.text("contract", s.contract...);
    visit.text("sensor", s.sensor...);
    visit.number("process_id", s.process_id...);
    visit.choice("state", s.state...);
    visit.choice("transport_in_force", s.transport_in_force...);
    visit.text("transport_reason", s.transport_reason...);
    visit.number("frames_in", s.frames_in...);
    visit.number("frames_out", s.frames_out...);
    visit.number("frames_dropped", s.frames_dropped...);
    visit.number("frames_rejected", s.frames_rejected...);
    visit.number("frames_in_flight", s.frames_in_flight...);
    visit.number("frames_zero_copy", s.frames_zero_copy...);
    visit.number("interruptions", s.interruptions...);
    visit.each("dropped_by_cause", cause_count, s.dropped_by_cause...);
    visit.each("rejected_by_cause", cause_count, s.rejected_by_cause...);
    visit.number("rate_hz", s.rate_hz...);
    visit.number("latency_median_ms", s.latency_median_ms...);
    visit.number("latency_p90_ms", s.latency_p90_ms...);
    visit.number("latency_p99_ms", s.latency_p99_ms...);
    visit.number("cpu_time_s", s.cpu_time_s...);
    visit.text("last_error", s.last_error...);
  }
};
inline constexpr NodeStatusFields node_status;

}  // namespace cleave::fields
