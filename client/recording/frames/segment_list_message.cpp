#include "recording/frames/segment_list_message.hpp"

#include "recording/frames/header_message.hpp"

namespace cleave::recording {
namespace {

// One list of the fields for both directions, so that they cannot disagree.
struct Write {
  CdrWriter& cdr;
  template <class Number>
  void operator()(const Number& value) {
    cdr.number(value);
  }
};

struct Read {
  CdrReader& cdr;
  template <class Number>
  void operator()(Number& value) {
    value = cdr.number<Number>();
  }
};

template <class Visit, class AnySegment>
void visit_fields(Visit visit, AnySegment& s) {
  visit(s.label);
  visit(s.point_count);
  for (auto* vector : {&s.centroid, &s.mean_normal, &s.box_centre}) {
    for (auto& value : *vector) visit(value);
  }
  for (auto& value : s.box_orientation) visit(value);
  for (auto& value : s.box_extent) visit(value);
  for (auto& value : s.rectangle) visit(value);
  visit(s.planarity);
}

constexpr std::size_t smallest_segment = 80;
constexpr std::size_t smallest_border = 8;
constexpr std::uint32_t concave = 0;
constexpr std::uint32_t convex = 1;

}  // namespace

Bytes segment_list_message(const SegmentList& list) {
  CdrWriter cdr;
  write_header(cdr, list.header);
  cdr.number(list.cloud_publication_time_ns);
  cdr.number(list.cloud_reception_time_ns);
  cdr.number(list.outcome);
  cdr.length(list.segments.size());
  for (const Segment& segment : list.segments) visit_fields(Write{cdr}, segment);
  cdr.length(list.borders.size());
  for (const Border& border : list.borders) {
    cdr.number(border.first);
    cdr.number(border.second);
    cdr.number(border.convex ? convex : concave);
  }
  cdr.number(list.queue_ms);
  cdr.number(list.segmentation_ms);
  return cdr.bytes();
}

SegmentList read_segment_list(ByteView message) {
  CdrReader cdr(message);
  SegmentList list;
  list.header = read_header(cdr);
  list.cloud_publication_time_ns = cdr.number<std::int64_t>();
  list.cloud_reception_time_ns = cdr.number<std::int64_t>();
  list.outcome = cdr.number<std::uint32_t>();
  list.segments.resize(cdr.length(smallest_segment));
  for (Segment& segment : list.segments) visit_fields(Read{cdr}, segment);
  list.borders.resize(cdr.length(smallest_border));
  for (Border& border : list.borders) {
    border.first = cdr.number<std::uint16_t>();
    border.second = cdr.number<std::uint16_t>();
    border.convex = cdr.number<std::uint32_t>() == convex;
  }
  list.queue_ms = cdr.number<float>();
  list.segmentation_ms = cdr.number<float>();
  return list;
}

}  // namespace cleave::recording
