// SPDX-License-Identifier: BSD-3-Clause
// Recordings by OpenNI (.oni) as frames of a sensor, with the points that the grabber publishes
// when it plays them.
#include <spdlog/spdlog.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "recording/oni/camera.hpp"
#include "recording/sources/frame_source.hpp"

namespace cleave::recording {
namespace {

// What is too large for a recording its writer refuses, and names.
constexpr std::uint64_t any_size = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t ns_per_us = 1000;
constexpr std::uint64_t latest_us = std::numeric_limits<std::int64_t>::max() / ns_per_us;

oni::Camera camera_of(const oni::Reader& reader, const std::filesystem::path& path) {
  try {
    return oni::Camera(reader, any_size);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("cannot convert the recording '" + path.string() +
                             "': " + error.what());
  }
}

// Not that of the first frame: in a damaged file that may be any number.
std::uint64_t earliest_us(const oni::Reader& reader) {
  std::uint64_t earliest = reader.timestamp_us(0);
  for (std::size_t i = 1; i < reader.size(); ++i) {
    earliest = std::min(earliest, reader.timestamp_us(i));
  }
  return earliest;
}

class OniFrames : public FrameSource {
 public:
  OniFrames(const std::filesystem::path& path, std::string sensor)
      : path_(path),
        reader_(path),
        camera_(camera_of(reader_, path)),
        start_us_(earliest_us(reader_)),
        sensor_(std::move(sensor)) {
    if (!reader_.damage().empty()) skip(reader_.damage());
  }

  std::optional<Frame> next() override {
    while (next_ < reader_.size()) {
      if (const auto why = reader_.read(next_++, depth_)) {
        skip("skipped: " + *why);
      } else if (depth_.timestamp_us - start_us_ > latest_us) {
        skip("skipped: frame " + std::to_string(next_) + " in the recording '" + path_.string() +
             "' has a time stamp that cannot be: " + std::to_string(depth_.timestamp_us) + " us");
      } else {
        return frame();
      }
    }
    return std::nullopt;
  }
  [[nodiscard]] std::size_t skipped() const override { return skipped_; }

 private:
  Frame frame() {
    const oni::DepthStream& stream = reader_.stream();
    camera_.turn_back(depth_);
    Cloud cloud;
    cloud.xyz.resize(3 * depth_.depth.size());
    camera_.write_points(depth_, cloud.xyz.data());
    const auto time_ns = static_cast<std::int64_t>((depth_.timestamp_us - start_us_) * ns_per_us);
    cloud.header.frame_id = ++frames_;
    cloud.header.capture_time_ns = time_ns;
    cloud.header.device_time_us = depth_.timestamp_us;
    cloud.header.width = stream.width;
    cloud.header.height = stream.height;
    cloud.header.fx = camera_.intrinsics().fx;
    cloud.header.fy = camera_.intrinsics().fy;
    cloud.header.cx = camera_.intrinsics().cx;
    cloud.header.cy = camera_.intrinsics().cy;
    cloud.header.sensor = sensor_;
    cloud.header.coordinate_frame = sensor_ + "_optical";
    return {time_ns, std::move(cloud)};
  }

  void skip(const std::string& why) {
    spdlog::warn("{}", why);
    ++skipped_;
  }

  std::filesystem::path path_;
  oni::Reader reader_;
  oni::Camera camera_;
  std::uint64_t start_us_;
  std::string sensor_;
  oni::DepthFrame depth_;
  std::size_t next_ = 0;
  std::uint64_t frames_ = 0;
  std::size_t skipped_ = 0;
};

}  // namespace

std::unique_ptr<FrameSource> open_oni(const std::filesystem::path& path,
                                      const std::string& sensor) {
  return std::make_unique<OniFrames>(path, sensor);
}

}  // namespace cleave::recording
