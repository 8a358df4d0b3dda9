// SPDX-License-Identifier: BSD-3-Clause
#include "recording/frames/scene_update.hpp"

#include <cmath>
#include <string>

#include "recording/cdr/cdr.hpp"
#include "recording/time_units.hpp"

namespace cleave::recording {
namespace {

void write_point(CdrWriter& cdr, const Point& p) {
  for (const float value : {p.x, p.y, p.z}) cdr.number(double{value});
}

void write_quaternion(CdrWriter& cdr, const Quaternion& q) {
  for (const float value : {q.x, q.y, q.z, q.w}) cdr.number(double{value});
}

// Hues that step by the golden ratio: labels that follow each other differ most.
void write_colour(CdrWriter& cdr, std::uint16_t label, double opacity) {
  constexpr double golden_ratio = 0.618033988749895;
  const double hue = std::fmod(label * golden_ratio, 1.0) * 6;
  for (const double shift : {0.0, 4.0, 2.0}) {
    const double distance = std::fabs(std::fmod(hue + shift, 6.0) - 3);
    cdr.number(std::fmin(std::fmax(distance - 1, 0.0), 1.0));
  }
  cdr.number(opacity);
}

void write_box(CdrWriter& cdr, const Segment& segment) {
  constexpr double opacity = 0.4;
  write_point(cdr, segment.box.centre);
  write_quaternion(cdr, segment.box.orientation);
  write_point(cdr, segment.box.extent);
  write_colour(cdr, segment.label, opacity);
}

void write_text(CdrWriter& cdr, const Segment& segment) {
  constexpr double font_size_m = 0.03;
  write_point(cdr, segment.box.centre);
  for (const double q : {0.0, 0.0, 0.0, 1.0}) cdr.number(q);
  cdr.boolean(true);  // faces the camera
  cdr.number(font_size_m);
  cdr.boolean(false);  // grows and shrinks with the scene
  for (const double white : {1.0, 1.0, 1.0, 1.0}) cdr.number(white);
  cdr.string(std::to_string(segment.label));
}

}  // namespace

Bytes scene_update_message(const SegmentList& list) {
  const FrameHeader& header = list.header;
  CdrWriter cdr;
  cdr.length(0);  // deletions
  cdr.length(1);  // entities
  cdr.number(static_cast<std::int32_t>(header.capture_time_ns / ns_per_s));
  cdr.number(static_cast<std::uint32_t>(header.capture_time_ns % ns_per_s));
  cdr.string(header.coordinate_frame);
  cdr.string("segments");
  cdr.number(std::int32_t{0});  // lifetime: until it is replaced
  cdr.number(std::uint32_t{0});
  cdr.boolean(false);  // frame_locked
  cdr.length(0);       // metadata
  cdr.length(0);       // arrows
  cdr.length(list.segments.size());
  for (const Segment& segment : list.segments) write_box(cdr, segment);
  for (const char* none : {"spheres", "cylinders", "lines", "triangles"}) {
    (void)none;
    cdr.length(0);
  }
  cdr.length(list.segments.size());
  for (const Segment& segment : list.segments) write_text(cdr, segment);
  cdr.length(0);  // models
  return cdr.bytes();
}

}  // namespace cleave::recording
