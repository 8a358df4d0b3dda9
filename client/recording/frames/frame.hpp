// SPDX-License-Identifier: BSD-3-Clause
// recording::Frame: what recordings hold, free of any transport: one message, be it a cloud, a
// label map or a segment list. The contract's types in plain C++, with the members that
// idl/fields.hpp visits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "idl/capacity.hpp"

namespace cleave::recording {

struct Point {
  float x = 0, y = 0, z = 0;
  bool operator==(const Point&) const = default;
};

struct Quaternion {
  float x = 0, y = 0, z = 0, w = 0;
  bool operator==(const Quaternion&) const = default;
};

// p_parent = orientation * p + position.
struct Pose {
  Point position;          // metres
  Quaternion orientation;  // unit length; all 0 = not known
  bool operator==(const Pose&) const = default;
};

// As the contract's FrameHeader.
struct FrameHeader {
  std::uint64_t frame_id = 0;
  std::uint32_t epoch = 0;
  std::int64_t capture_time_ns = 0;      // wall clock
  std::int64_t arrival_time_ns = 0;      // CLOCK_MONOTONIC of the machine that recorded
  std::int64_t publication_time_ns = 0;  // the same clock
  std::uint64_t device_time_us = 0;
  std::uint32_t width = 0;
  std::uint32_t height = 0;  // 1 = unorganised
  float fx = 0;              // pixels; all 0 = not an image
  float fy = 0;
  float cx = 0;
  float cy = 0;
  std::string sensor;            // at most 63 characters
  std::string coordinate_frame;  // at most 63 characters
  std::string parent_frame;      // at most 63 characters
  Pose pose;                     // of coordinate_frame in parent_frame
  bool operator==(const FrameHeader&) const = default;

  [[nodiscard]] std::uint64_t points() const { return std::uint64_t{width} * height; }
};

// Points x, y, z in metres, row-major, optical frame; NaN = no measurement.
struct Cloud {
  FrameHeader header;
  std::vector<float> xyz;  // 3 * points
};

// 0 = no segment.
struct Labels {
  FrameHeader header;
  std::int64_t cloud_publication_time_ns = 0;
  std::vector<std::uint16_t> label;  // one a point
  bool operator==(const Labels&) const = default;
};

struct ImageRectangle {
  std::uint32_t left = 0, top = 0, right = 0, bottom = 0;
  bool operator==(const ImageRectangle&) const = default;
};

struct OrientedBox {
  Point centre;
  Quaternion orientation;
  Point extent;
  bool operator==(const OrientedBox&) const = default;
};

struct Segment {
  std::uint16_t label = 0;
  std::uint32_t point_count = 0;
  Point centroid;
  Point mean_normal;
  OrientedBox box;
  ImageRectangle rectangle;
  float planarity = 0;
  bool operator==(const Segment&) const = default;
};

enum class BorderKind : std::uint32_t { concave, convex };
[[nodiscard]] const char* name_of(BorderKind kind);  // "concave", "convex"

struct Border {
  std::uint16_t first = 0;
  std::uint16_t second = 0;
  BorderKind kind = BorderKind::concave;
  bool operator==(const Border&) const = default;
};

// Why a frame has segments, or none. Another version's may have values beyond these.
enum class FrameOutcome : std::uint32_t {
  segmented,
  bad_size,
  bad_header,
  no_finite_point,
  segmentation_failed,
  too_many_segments,
  wrong_unit
};
// "segmented", "bad size", ...; "unknown".
[[nodiscard]] const char* name_of(FrameOutcome outcome);

// As the contract's SegmentList.
struct SegmentList {
  FrameHeader header;
  std::int64_t cloud_publication_time_ns = 0;
  std::int64_t cloud_reception_time_ns = 0;
  FrameOutcome outcome = FrameOutcome::segmented;
  std::vector<Segment> segments;
  std::vector<Border> borders;
  float queue_ms = 0;
  float segmentation_ms = 0;
  bool operator==(const SegmentList&) const = default;
};

enum class Kind { cloud, labels, segments };

// A cloud and its labels are two of these, with the same header.
struct Frame {
  std::int64_t log_time_ns = 0;  // when it was recorded, wall clock
  std::variant<Cloud, Labels, SegmentList> content;

  [[nodiscard]] Kind kind() const { return static_cast<Kind>(content.index()); }
  [[nodiscard]] const FrameHeader& header() const {
    return std::visit([](const auto& c) -> const FrameHeader& { return c.header; }, content);
  }
};

}  // namespace cleave::recording
