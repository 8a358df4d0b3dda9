// SPDX-License-Identifier: BSD-3-Clause
// PCD files as frames of a sensor.
#include <spdlog/spdlog.h>

#include <utility>
#include <vector>

#include "recording/pcd/error.hpp"
#include "recording/pcd/folder.hpp"
#include "recording/pcd/origin_remark.hpp"
#include "recording/pcd/stream_cloud.hpp"
#include "recording/sources/frame_source.hpp"
#include "recording/units/suspected_unit.hpp"

namespace cleave::recording {
namespace {

// Files say nothing of their time: the first is of time 0, as if taken at 30 frames a second, so
// that the same files make the same recording.
constexpr std::int64_t period_ns = 33'333'333;

class PcdFrames : public FrameSource {
 public:
  PcdFrames(const std::filesystem::path& path, std::string sensor, std::optional<Unit> unit,
            std::uint64_t max_points)
      : files_(pcd_files(path)), sensor_(std::move(sensor)), unit_(unit), max_points_(max_points) {}

  std::optional<Frame> next() override {
    while (next_ < files_.size()) {
      const std::filesystem::path& file = files_[next_++];
      try {
        return read(file);
      } catch (const PcdError& error) {
        skip(error.what());
      } catch (const WrongUnit& error) {
        skip(error.what());
      }
    }
    return std::nullopt;
  }
  [[nodiscard]] std::size_t skipped() const override { return skipped_; }

 private:
  Frame read(const std::filesystem::path& file) {
    StreamCloud pcd = read_stream_cloud(file, max_points_, unit_);
    if (const auto remark = origins_.of(file, pcd)) spdlog::warn("{}", *remark);
    Cloud cloud;
    cloud.xyz = std::move(pcd.xyz);
    const std::int64_t time_ns = static_cast<std::int64_t>(frames_) * period_ns;
    cloud.header.frame_id = ++frames_;
    cloud.header.capture_time_ns = time_ns;
    cloud.header.width = pcd.width;
    cloud.header.height = pcd.height;
    cloud.header.fx = pcd.intrinsics.fx;
    cloud.header.fy = pcd.intrinsics.fy;
    cloud.header.cx = pcd.intrinsics.cx;
    cloud.header.cy = pcd.intrinsics.cy;
    cloud.header.sensor = sensor_;
    cloud.header.coordinate_frame = sensor_ + "_optical";
    return {time_ns, std::move(cloud)};
  }

  void skip(const char* why) {
    spdlog::warn("skipped: {}", why);
    ++skipped_;
  }

  std::vector<std::filesystem::path> files_;
  std::string sensor_;
  std::optional<Unit> unit_;
  std::uint64_t max_points_;
  std::size_t next_ = 0;
  std::uint64_t frames_ = 0;
  std::size_t skipped_ = 0;
  OriginRemark origins_;
};

}  // namespace

std::unique_ptr<FrameSource> open_pcd(const std::filesystem::path& path, const std::string& sensor,
                                      std::optional<Unit> unit, std::uint64_t max_points) {
  return std::make_unique<PcdFrames>(path, sensor, unit, max_points);
}

}  // namespace cleave::recording
