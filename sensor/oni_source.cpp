#include "sensor/oni_source.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "libcleave/types.hpp"

namespace cleave::sensor {

OniSource::OniSource(const std::filesystem::path& file, bool loop)
    : path_(std::filesystem::absolute(file)), loop_(loop) {}

Failure OniSource::open() {
  try {
    reader_.emplace(path_);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  next_ = 0;
  if (Failure failure = prepare()) {
    return "cannot play the recording '" + path_.string() + "': " + *failure;
  }
  if (!reader_->damage().empty()) spdlog::warn("{}", reader_->damage());
  return std::nullopt;
}

Failure OniSource::prepare() {
  const oni::DepthStream& stream = reader_->stream();
  const std::string size = std::to_string(stream.width) + " x " + std::to_string(stream.height);
  if (reader_->size() == 0) return "it has no frame";
  if (std::size_t{stream.width} * stream.height > capacity_points) {
    return "its images have " + size + " pixels, at most 640 x 480 fit into a cloud";
  }
  intrinsics_ = intrinsics_from_fov(stream.sensor_width, stream.sensor_height,
                                    static_cast<float>(stream.horizontal_fov_rad),
                                    static_cast<float>(stream.vertical_fov_rad));
  if (intrinsics_.fx == 0) return "it does not tell its camera's field of view";
  intrinsics_.cx -= static_cast<float>(stream.cropping.x);
  intrinsics_.cy -= static_cast<float>(stream.cropping.y);
  if (stream.mirrored) intrinsics_.cx = static_cast<float>(stream.width - 1) - intrinsics_.cx;
  projection_ = DepthProjection(stream.width, stream.height, intrinsics_);
  spdlog::info("opened {}: {} pixels, frames: {}", path_.string(), size, reader_->size());
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
  frame = {stream.width, stream.height, intrinsics_, wall_now_ns(), held_.timestamp_us, again};
  return Poll::frame;
}

bool OniSource::read_next() {
  while (next_ < reader_->size()) {
    const auto why = reader_->read(next_++, held_);
    if (!why) {
      if (reader_->stream().mirrored) turn_back();
      return true;
    }
    ++damaged_;
    if (std::uint64_t suppressed = 0; log_limiter_.allow(suppressed)) {
      spdlog::warn("skipped {} ({} more before)", *why, suppressed);
    }
  }
  return false;
}

void OniSource::turn_back() {
  const std::uint32_t width = reader_->stream().width;
  for (auto row = held_.depth.begin(); row != held_.depth.end(); row += width) {
    std::reverse(row, row + width);
  }
}

void OniSource::write_points(float* xyz) {
  const oni::DepthStream& stream = reader_->stream();
  projection_.write_points({held_.depth.data(), stream.width, stream.height,
                            std::size_t{stream.width} * sizeof(std::uint16_t), stream.unit_m},
                           xyz);
}

SourceCounts OniSource::counts() const {
  SourceCounts counts;
  if (damaged_ > 0) counts.unusable["damaged frame"] = damaged_;
  return counts;
}

}  // namespace cleave::sensor
