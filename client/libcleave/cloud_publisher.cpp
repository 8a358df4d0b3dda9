// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/cloud_publisher.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "libcleave/process/sensor_lock.hpp"
#include "libcleave/status.hpp"
#include "recording/cloud/depth_to_points.hpp"

namespace cleave {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds status_interval(500);
constexpr float unit_tolerance = 0.01F;
constexpr float no_measurement = std::numeric_limits<float>::quiet_NaN();

void require(bool holds, const std::string& what) {
  if (!holds) throw std::invalid_argument("a cloud publisher needs " + what);
}

void check(const CloudSettings& s) {
  require(is_valid_sensor_name(s.sensor),
          "a sensor of 1 to 63 letters, digits or '_', not '" + s.sensor + "'");
  const std::uint64_t points = std::uint64_t{s.width} * s.height;
  require(points > 0 && points <= capacity_points, "1 to " + std::to_string(capacity_points) +
                                                       " points, not " + std::to_string(s.width) +
                                                       " x " + std::to_string(s.height));
  const bool image = s.fx != 0 || s.fy != 0 || s.cx != 0 || s.cy != 0;
  require(!image || (s.fx > 0 && s.fy > 0 && std::isfinite(s.fx + s.fy + s.cx + s.cy)),
          "positive focal lengths fx and fy, or no intrinsics at all");
  const auto& q = s.orientation;
  const float length = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
  require(s.parent_frame.empty() ? length == 0 : std::abs(length - 1) < unit_tolerance,
          "parent_frame and an orientation of unit length both, or neither");
}

FrameHeader header_of(const CloudSettings& s) {
  FrameHeader header{};
  header.width = s.width;
  header.height = s.height;
  header.fx = s.fx;
  header.fy = s.fy;
  header.cx = s.cx;
  header.cy = s.cy;
  header.epoch = static_cast<std::uint32_t>(wall_now_ns() / 1'000'000'000);
  require(set_name(header.sensor, s.sensor) &&
              set_name(header.coordinate_frame, s.coordinate_frame) &&
              set_name(header.parent_frame, s.parent_frame),
          "names of at most 63 characters");
  header.pose = {{s.position[0], s.position[1], s.position[2]},
                 {s.orientation[0], s.orientation[1], s.orientation[2], s.orientation[3]}};
  return header;
}

CloudSettings with_defaults(CloudSettings settings) {
  if (settings.coordinate_frame.empty()) {
    settings.coordinate_frame = (settings.sensor + "_optical").substr(0, max_sensor_name_length);
  }
  check(settings);
  return settings;
}

}  // namespace

struct CloudPublisher::State {
  State(Stream& stream, CloudSettings s)
      : settings(with_defaults(std::move(s))),
        header(header_of(settings)),
        lock(stream.options().domain, settings.sensor),
        writer(stream, settings.sensor),
        statuses(stream),
        report(first_report(stream, grabber_node(settings.sensor), settings.sensor)),
        projection(settings.width, settings.height,
                   {settings.fx, settings.fy, settings.cx, settings.cy}) {
    report.state = NodeState::running;
    report.last_error.clear();
    tell();
  }

  void tell() {
    next_status = Clock::now() + status_interval;
    report.cpu_time_s = cpu_time_s();
    statuses.publish(report);
  }
  bool drop(const char* cause) {
    ++report.frames_in;
    ++report.frames_dropped;
    ++report.dropped_by_cause[cause];
    if (Clock::now() >= next_status) tell();
    return false;
  }
  void check_size(std::size_t found, std::size_t expected) const {
    if (found == expected) return;
    throw std::invalid_argument("a frame of " + std::to_string(settings.width) + " x " +
                                std::to_string(settings.height) + " points has " +
                                std::to_string(expected) + " values, not " + std::to_string(found));
  }
  [[nodiscard]] std::size_t points() const { return std::size_t{settings.width} * settings.height; }
  void check_depth(std::size_t found) const {
    check_size(found, points());
    if (settings.fx == 0) {
      throw std::invalid_argument(
          "depth becomes points by the intrinsics fx, fy, cx and cy, which "
          "the publisher was not given");
    }
  }

  const CloudSettings settings;
  FrameHeader header;  // of the frame before
  SensorLock lock;
  CloudWriter writer;
  StatusPublisher statuses;
  NodeReport report;
  recording::DepthProjection projection;
  Clock::time_point next_status{};
  bool lacked_memory = false;
};

CloudPublisher::CloudPublisher(Stream& stream, CloudSettings settings)
    : state_(std::make_unique<State>(stream, std::move(settings))) {}

CloudPublisher::~CloudPublisher() {
  state_->report.state = NodeState::ended;
  state_->tell();
}

bool CloudPublisher::publish_depth(std::span<const std::uint16_t> depth, float unit_m,
                                   std::int64_t capture_time_ns) {
  const State& s = *state_;
  s.check_depth(depth.size());
  require(unit_m > 0 && std::isfinite(unit_m), "a unit of depth in metres, more than 0");
  std::optional<CloudLoan> cloud = loan();
  if (!cloud) return false;
  s.projection.write_points({depth.data(), s.settings.width, s.settings.height,
                             std::size_t{s.settings.width} * sizeof(std::uint16_t), unit_m},
                            cloud->room().data());
  return publish(std::move(*cloud), capture_time_ns);
}

bool CloudPublisher::publish_depth(std::span<const float> depth_m, std::int64_t capture_time_ns) {
  const State& s = *state_;
  s.check_depth(depth_m.size());
  std::optional<CloudLoan> cloud = loan();
  if (!cloud) return false;
  const std::span<float> xyz = cloud->room().first(3 * s.points());
  s.projection.write_points(depth_m, xyz.data());
  for (std::size_t i = 0; i < xyz.size(); i += 3) {
    if (xyz[i + 2] == 0) std::ranges::fill(xyz.subspan(i, 3), no_measurement);
  }
  return publish(std::move(*cloud), capture_time_ns);
}

bool CloudPublisher::publish_points(std::span<const float> xyz, std::int64_t capture_time_ns) {
  state_->check_size(xyz.size(), 3 * state_->points());
  std::optional<CloudLoan> cloud = loan();
  if (!cloud) return false;
  std::ranges::copy(xyz, cloud->room().begin());
  return publish(std::move(*cloud), capture_time_ns);
}

std::optional<CloudLoan> CloudPublisher::loan() {
  std::optional<CloudLoan> cloud = state_->writer.loan(state_->points());
  state_->lacked_memory = !cloud;
  if (!cloud) {
    (void)state_->drop(obstacle().empty() ? "no free chunk" : "no chunks for large clouds");
  }
  return cloud;
}

bool CloudPublisher::publish(CloudLoan&& cloud, std::int64_t capture_time_ns) {
  State& s = *state_;
  const std::int64_t now_ns = monotonic_now_ns();
  ++s.header.frame_id;
  s.header.capture_time_ns = capture_time_ns != 0 ? capture_time_ns : wall_now_ns();
  s.header.arrival_time_ns = now_ns;
  s.header.publication_time_ns = now_ns;
  cloud.header() = s.header;
  if (!std::move(cloud).publish()) {
    --s.header.frame_id;
    return s.drop("refused by DDS");
  }
  ++s.report.frames_in;
  ++s.report.frames_out;
  if (s.writer.zero_copy()) ++s.report.frames_zero_copy;
  if (Clock::now() >= s.next_status) s.tell();
  return true;
}

unsigned CloudPublisher::readers() const {
  return state_->writer.matched_readers();
}
bool CloudPublisher::lacked_memory() const {
  return state_->lacked_memory;
}
std::string CloudPublisher::obstacle() const {
  return state_->writer.obstacle();
}
std::uint64_t CloudPublisher::published() const {
  return state_->report.frames_out;
}
std::uint64_t CloudPublisher::dropped() const {
  return state_->report.frames_dropped;
}
const CloudSettings& CloudPublisher::settings() const {
  return state_->settings;
}

}  // namespace cleave
