// SPDX-License-Identifier: BSD-3-Clause
#include "recording/ros/camera_book.hpp"

#include <utility>

namespace cleave::recording::ros {
namespace {

// An image is looked up when the next one comes; between two there are one or two of these.
constexpr std::size_t most_remembered = 64;

// Whether `a` is a better answer than `b` for the image.
bool is_better(const Moment& a, const Moment& b, const Moment& image) {
  const bool a_precedes = a.stamp_ns <= image.stamp_ns;
  const bool b_precedes = b.stamp_ns <= image.stamp_ns;
  if (a_precedes != b_precedes) return a_precedes;
  if (a.stamp_ns != b.stamp_ns) return (a.stamp_ns > b.stamp_ns) == a_precedes;
  const bool a_is_logged = a.log_ns <= image.log_ns;
  const bool b_is_logged = b.log_ns <= image.log_ns;
  if (a_is_logged != b_is_logged) return a_is_logged;
  return a.log_ns != b.log_ns && (a.log_ns > b.log_ns) == a_is_logged;
}

}  // namespace

Moment moment_of(const Header& header, const MessageTimes& times) {
  const auto log_ns = static_cast<std::int64_t>(times.log_ns);
  return {header.stamp_ns == 0 ? log_ns : header.stamp_ns, log_ns};
}

RecordedCamera recorded_camera(const Message& message, Wire wire) {
  CameraInfo info = read_camera_info(reader_of(message.data, wire));
  const Moment when = moment_of(info.header, message.times);
  return {when, std::move(info)};
}

void CameraBook::add(RecordedCamera camera) {
  latest_.push_back(std::move(camera));
  if (latest_.size() > most_remembered) latest_.pop_front();
}

const CameraInfo& CameraBook::of_image(const Moment& image) const {
  const RecordedCamera* best = &first_;
  for (const RecordedCamera& camera : latest_) {
    if (is_better(camera.when, best->when, image)) best = &camera;
  }
  return best->info;
}

}  // namespace cleave::recording::ros
