// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/sources/oni_source.hpp"

#include <spdlog/spdlog.h>

#include <stdexcept>
#include <utility>

#include "libcleave/types.hpp"

namespace cleave::sensor {

OniSource::OniSource(const std::filesystem::path& file, bool loop, std::uint64_t max_points)
    : path_(std::filesystem::absolute(file)), loop_(loop), max_points_(max_points) {}

Failure OniSource::open() {
  try {
    reader_.emplace(path_);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  next_ = 0;
  try {
    camera_.emplace(*reader_, max_points_);
  } catch (const std::runtime_error& error) {
    return "cannot play the recording '" + path_.string() + "': " + error.what();
  }
  const oni::DepthStream& stream = reader_->stream();
  spdlog::info("opened {}: {} x {} pixels, frames: {}", path_.string(), stream.width, stream.height,
               reader_->size());
  if (!reader_->damage().empty()) spdlog::warn("{}", reader_->damage());
  return std::nullopt;
}

Poll OniSource::next(std::chrono::milliseconds /*timeout*/, Frame& frame) {
  bool again = false;
  while (!read_next()) {
    // A recording all of whose frames are damaged must not be looped for ever.
    if (!loop_ || std::exchange(again, true)) return Poll::end;
    next_ = 0;
  }
  const oni::DepthStream& stream = reader_->stream();
  frame = {stream.width,  stream.height,      camera_->intrinsics(),
           wall_now_ns(), held_.timestamp_us, again};
  return Poll::frame;
}

bool OniSource::read_next() {
  while (next_ < reader_->size()) {
    const auto why = reader_->read(next_++, held_);
    if (!why) {
      camera_->turn_back(held_);
      return true;
    }
    ++damaged_;
    if (std::uint64_t suppressed = 0; log_limiter_.allow(suppressed)) {
      spdlog::warn("skipped {} ({} more before)", *why, suppressed);
    }
  }
  return false;
}

void OniSource::write_points(float* xyz) {
  camera_->write_points(held_, xyz);
}

SourceCounts OniSource::counts() const {
  SourceCounts counts;
  if (damaged_ > 0) counts.unusable["damaged frame"] = damaged_;
  return counts;
}

}  // namespace cleave::sensor
