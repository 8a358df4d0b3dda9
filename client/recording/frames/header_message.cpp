#include "recording/frames/header_message.hpp"

namespace cleave::recording {
namespace {

constexpr std::size_t name_size = 64;

}  // namespace

void write_header(CdrWriter& cdr, const FrameHeader& h) {
  cdr.number(h.frame_id);
  cdr.number(h.epoch);
  cdr.number(h.capture_time_ns);
  cdr.number(h.arrival_time_ns);
  cdr.number(h.publication_time_ns);
  cdr.number(h.device_time_us);
  cdr.number(h.width);
  cdr.number(h.height);
  for (const float value : {h.fx, h.fy, h.cx, h.cy}) cdr.number(value);
  cdr.characters(h.sensor, name_size);
  cdr.characters(h.coordinate_frame, name_size);
}

FrameHeader read_header(CdrReader& cdr) {
  FrameHeader h;
  h.frame_id = cdr.number<std::uint64_t>();
  h.epoch = cdr.number<std::uint32_t>();
  h.capture_time_ns = cdr.number<std::int64_t>();
  h.arrival_time_ns = cdr.number<std::int64_t>();
  h.publication_time_ns = cdr.number<std::int64_t>();
  h.device_time_us = cdr.number<std::uint64_t>();
  h.width = cdr.number<std::uint32_t>();
  h.height = cdr.number<std::uint32_t>();
  for (float* value : {&h.fx, &h.fy, &h.cx, &h.cy}) *value = cdr.number<float>();
  h.sensor = cdr.characters(name_size);
  h.coordinate_frame = cdr.characters(name_size);
  if (h.points() > capacity_points) {
    throw DataError("a frame has " + std::to_string(h.width) + " x " + std::to_string(h.height) +
                    " points, more than the stream carries");
  }
  return h;
}

}  // namespace cleave::recording
