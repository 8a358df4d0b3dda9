// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/grabber/frame_publisher.hpp"

#include <optional>
#include <stdexcept>
#include <utility>

namespace cleave::sensor {

FramePublisher::FramePublisher(Stream& stream, const std::string& sensor, const Place& place,
                               WriterDepth depth)
    : writer_(stream, sensor, depth), header_{} {
  if (!set_name(header_.sensor, sensor) ||
      !set_name(header_.coordinate_frame, place.coordinate_frame) ||
      !set_name(header_.parent_frame, place.parent_frame)) {
    throw std::invalid_argument("a name of sensor or frame is longer than 63");
  }
  header_.pose = place.pose;
}

Publication FramePublisher::publish(const Frame& frame, FrameKey key, Source& source,
                                    KeptFrame* copy) {
  std::optional<CloudLoan> cloud = writer_.loan(std::uint64_t{frame.width} * frame.height);
  if (!cloud && !writer_.obstacle().empty()) return Publication::no_large_chunks;
  if (!cloud) return Publication::no_free_chunk;
  FrameHeader& header = cloud->header();
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
  source.write_points(cloud->room().data());
  if (copy != nullptr) {
    copy->header = header;
    const auto xyz = cloud->room().first(3 * static_cast<std::size_t>(point_count(header)));
    copy->xyz.assign(xyz.begin(), xyz.end());
  }
  header.publication_time_ns = monotonic_now_ns();
  return std::move(*cloud).publish() ? Publication::done : Publication::refused;
}

}  // namespace cleave::sensor
