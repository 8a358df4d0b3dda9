// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "c/cleave.h"
#include "c/errors.hpp"
#include "c/handles.hpp"
#include "libcleave/cloud_publisher.hpp"

namespace cleave::c {
namespace {

CloudSettings settings_of(const cleave_camera& camera) {
  const auto text = [](const char* given) { return std::string(given != nullptr ? given : ""); };
  CloudSettings s;
  s.sensor = &given(camera.sensor, "camera->sensor");
  s.width = camera.width;
  s.height = camera.height;
  s.fx = camera.fx;
  s.fy = camera.fy;
  s.cx = camera.cx;
  s.cy = camera.cy;
  s.coordinate_frame = text(camera.coordinate_frame);
  s.parent_frame = text(camera.parent_frame);
  if (s.parent_frame.empty()) return s;
  const cleave_point& p = camera.pose.position;
  const cleave_quaternion& q = camera.pose.orientation;
  s.position = {p.x, p.y, p.z};
  s.orientation = {q.x, q.y, q.z, q.w};
  return s;
}

std::size_t points_of(const CloudPublisher& publisher) {
  return std::size_t{publisher.settings().width} * publisher.settings().height;
}

// `values`: those that are announced, not more than the publisher would look at.
template <class T>
std::span<const T> frame_of(const T* first, const char* name, std::size_t points,
                            std::size_t values_a_point) {
  const std::size_t most = capacity_points + 1;  // refused by its size all the same
  return {&given(first, name), std::min(points, most) * values_a_point};
}

cleave_result result_of(const cleave_publisher& publisher, bool published) {
  if (published) return CLEAVE_OK;
  if (!publisher.publisher.lacked_memory()) {
    return fail(CLEAVE_FAILED, "DDS refused the frame, which is dropped; the log says why");
  }
  const std::string obstacle = publisher.publisher.obstacle();
  return fail(CLEAVE_NO_MEMORY, obstacle.empty() ? "the frame is dropped: readers hold all chunks "
                                                   "of shared memory"
                                                 : "the frame is dropped: " + obstacle);
}

}  // namespace
}  // namespace cleave::c

using cleave::c::given;
using cleave::c::guarded;

cleave_result cleave_publisher_open(cleave_stream* stream, const cleave_camera* camera,
                                    cleave_publisher** publisher) {
  return guarded([&] {
    const auto& shared = given(stream, "stream").stream;
    cleave_publisher*& result = given(publisher, "publisher");
    const auto settings = cleave::c::settings_of(given(camera, "camera"));
    result = new cleave_publisher{shared, cleave::CloudPublisher(*shared, settings), std::nullopt};
    return CLEAVE_OK;
  });
}

void cleave_publisher_close(cleave_publisher* publisher) {
  delete publisher;
}

cleave_result cleave_publish_depth16(cleave_publisher* publisher, const uint16_t* depth,
                                     size_t count, float unit_m, int64_t capture_time_ns) {
  return guarded([&] {
    auto& p = given(publisher, "publisher");
    const auto frame = cleave::c::frame_of(depth, "depth", count, 1);
    return cleave::c::result_of(p, p.publisher.publish_depth(frame, unit_m, capture_time_ns));
  });
}

cleave_result cleave_publish_depth32(cleave_publisher* publisher, const float* depth_m,
                                     size_t count, int64_t capture_time_ns) {
  return guarded([&] {
    auto& p = given(publisher, "publisher");
    const auto frame = cleave::c::frame_of(depth_m, "depth_m", count, 1);
    return cleave::c::result_of(p, p.publisher.publish_depth(frame, capture_time_ns));
  });
}

cleave_result cleave_publish_points(cleave_publisher* publisher, const float* xyz, size_t count,
                                    int64_t capture_time_ns) {
  return guarded([&] {
    auto& p = given(publisher, "publisher");
    const auto frame = cleave::c::frame_of(xyz, "xyz", count, 3);
    return cleave::c::result_of(p, p.publisher.publish_points(frame, capture_time_ns));
  });
}

cleave_result cleave_loan(cleave_publisher* publisher, float** xyz, size_t* count) {
  return guarded([&] {
    auto& p = given(publisher, "publisher");
    float*& first = given(xyz, "xyz");
    size_t& points = given(count, "count");
    p.loan.reset();
    p.loan = p.publisher.loan();
    if (!p.loan) return cleave::c::result_of(p, false);
    first = p.loan->room().data();
    points = cleave::c::points_of(p.publisher);
    return CLEAVE_OK;
  });
}

cleave_result cleave_publish_loan(cleave_publisher* publisher, int64_t capture_time_ns) {
  return guarded([&] {
    auto& p = given(publisher, "publisher");
    if (!p.loan) throw std::invalid_argument("nothing is on loan: call cleave_loan() first");
    cleave::CloudLoan cloud = std::move(*p.loan);
    p.loan.reset();
    return cleave::c::result_of(p, p.publisher.publish(std::move(cloud), capture_time_ns));
  });
}

uint32_t cleave_publisher_readers(const cleave_publisher* publisher) {
  return publisher != nullptr ? publisher->publisher.readers() : 0;
}
