// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/grabber/cloud_publisher.hpp"

#include <optional>
#include <stdexcept>
#include <utility>

namespace cleave::sensor {

CloudPublisher::CloudPublisher(Stream& stream, const std::string& sensor,
                               const std::string& coordinate_frame, WriterDepth depth)
    : writer_(stream, sensor, depth), header_{} {
  if (!set_name(header_.sensor, sensor) || !set_name(header_.coordinate_frame, coordinate_frame)) {
    throw std::invalid_argument("the names of sensor and coordinate frame are longer than 63");
  }
}

Publication CloudPublisher::publish(const Frame& frame, FrameKey key, Source& source,
                                    KeptFrame* copy) {
  std::optional<Loan<DepthCloud>> cloud = writer_.loan();
  if (!cloud) return Publication::no_free_chunk;
  FrameHeader& header = (*cloud)->header;
  header = header_;
  header.frame_id = key.frame_id;
  header.epoch = key.epoch;
  header.capture_time_ns = frame.capture_time_ns;
  header.arrival_time_ns = frame.arrival_time_ns;
  header.device_time_us = frame.device_time_us;
  header.width = frame.width;
  header.height = frame.height;
  header.fx = frame.intrinsics.fx;
  header.fy = frame.intrinsics.fy;
  header.cx = frame.intrinsics.cx;
  header.cy = frame.intrinsics.cy;
  source.write_points((*cloud)->xyz);
  if (copy != nullptr) {
    copy->header = header;
    copy->xyz.assign((*cloud)->xyz, (*cloud)->xyz + 3 * point_count(header));
  }
  header.publication_time_ns = monotonic_now_ns();
  return writer_.publish(std::move(*cloud)) ? Publication::done : Publication::refused;
}

}  // namespace cleave::sensor
