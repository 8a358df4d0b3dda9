// PCD files as frames of a sensor.
#include <spdlog/spdlog.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "cleave/cloud/pcd_cloud.hpp"
#include "cleave/cloud/pcd_folder.hpp"
#include "cleave/recording/frame_source.hpp"
#include "libcleave/types.hpp"
#include "recording/cloud/fit_intrinsics.hpp"
#include "segmentation/view/measured.hpp"

namespace cleave::client {
namespace {

// Files say nothing of their time: the first is of time 0, as if taken at 30 frames a second, so
// that the same files make the same recording.
constexpr std::int64_t period_ns = 33'333'333;

// On the stream, a point without a measurement is NaN NaN NaN, whatever a file writes for it.
std::vector<float> stream_points(const segmentation::CloudView& view) {
  std::vector<float> xyz(view.xyz, view.xyz + 3 * view.size());
  for (std::size_t i = 0; i < xyz.size(); i += 3) {
    if (segmentation::is_measured(&xyz[i])) continue;
    std::fill_n(&xyz[i], 3, std::numeric_limits<float>::quiet_NaN());
  }
  return xyz;
}

class PcdFrames : public FrameSource {
 public:
  PcdFrames(const std::filesystem::path& path, std::string sensor)
      : files_(pcd_files(path)), sensor_(std::move(sensor)) {}

  std::optional<recording::Frame> next() override {
    while (next_ < files_.size()) {
      const std::filesystem::path& file = files_[next_++];
      try {
        return read(file);
      } catch (const PcdError& error) {
        spdlog::warn("skipped: {}", error.what());
        ++skipped_;
      }
    }
    return std::nullopt;
  }
  [[nodiscard]] std::size_t skipped() const override { return skipped_; }

 private:
  recording::Frame read(const std::filesystem::path& file) {
    const PcdCloud pcd = PcdCloud::read(file);
    const segmentation::CloudView view = pcd.view();
    if (view.size() > capacity_points) {
      throw PcdError(file.string() + ": has more than 640 x 480 points; sensors of that size only");
    }
    recording::Cloud cloud;
    cloud.xyz = stream_points(view);
    const recording::Intrinsics k =
        recording::fit_intrinsics(cloud.xyz.data(), view.width, view.height);
    const std::int64_t time_ns = static_cast<std::int64_t>(frames_) * period_ns;
    cloud.header.frame_id = ++frames_;
    cloud.header.capture_time_ns = time_ns;
    cloud.header.width = view.width;
    cloud.header.height = view.height;
    cloud.header.fx = k.fx;
    cloud.header.fy = k.fy;
    cloud.header.cx = k.cx;
    cloud.header.cy = k.cy;
    cloud.header.sensor = sensor_;
    cloud.header.coordinate_frame = sensor_ + "_optical";
    return {time_ns, std::move(cloud)};
  }

  std::vector<std::filesystem::path> files_;
  std::string sensor_;
  std::size_t next_ = 0;
  std::uint64_t frames_ = 0;
  std::size_t skipped_ = 0;
};

}  // namespace

std::unique_ptr<FrameSource> open_pcd(const std::filesystem::path& path,
                                      const std::string& sensor) {
  return std::make_unique<PcdFrames>(path, sensor);
}

}  // namespace cleave::client
