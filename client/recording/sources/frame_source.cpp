// SPDX-License-Identifier: BSD-3-Clause
#include "recording/sources/frame_source.hpp"

#include <spdlog/spdlog.h>

#include <array>
#include <utility>

#include "recording/error.hpp"
#include "recording/ros/open_frames.hpp"
#include "recording/units/suspected_unit.hpp"

namespace cleave::recording {
namespace {

constexpr std::string_view scheme = "mcap:";

void scale(Point& point, Unit unit) {
  std::array<float, 3> xyz = {point.x, point.y, point.z};
  recording::scale_to_metres(xyz, unit);
  point = {xyz[0], xyz[1], xyz[2]};
}

void scale_to_metres(SegmentList& list, Unit unit) {
  for (Segment& segment : list.segments) {
    scale(segment.centroid, unit);
    scale(segment.box.centre, unit);
    scale(segment.box.extent, unit);
  }
}

class McapFrames : public FrameSource {
 public:
  McapFrames(const FileTopic& from, const std::string& sensor, std::optional<Unit> unit)
      : input_(open_frames(from, {Kind::cloud, Kind::labels, Kind::segments}, sensor)),
        name_(from.file.string()),
        unit_(unit) {
    for (const std::string& remark : input_->remarks()) spdlog::warn("{}", remark);
  }

  std::optional<Frame> next() override {
    auto frame = input_->next();
    if (frame) make_metres(*frame);
    name_problems();
    return frame;
  }
  [[nodiscard]] std::size_t skipped() const override {
    std::size_t count = 0;
    for (const auto& [cause, frames] : input_->losses()) count += frames;
    return count;
  }

 private:
  // Those that are new: texts are copied only where something else was lost.
  void name_problems() {
    const std::size_t lost = skipped();
    if (lost == lost_) return;
    lost_ = lost;
    const auto problems = input_->problems();
    for (; named_ < problems.size(); ++named_) spdlog::warn("{}", problems[named_]);
  }

  // As cleave-grabber plays recordings: all clouds are in one unit, which the first one tells.
  void make_metres(Frame& frame) {
    if (auto* const cloud = std::get_if<Cloud>(&frame.content)) {
      const bool is_first = !std::exchange(has_cloud_, true);
      if (unit_ || is_first) recording::make_metres(cloud->xyz, unit_, name_);
    } else if (auto* const list = std::get_if<SegmentList>(&frame.content)) {
      if (unit_) scale_to_metres(*list, *unit_);
    }
  }

  std::unique_ptr<FrameInput> input_;
  std::string name_;
  std::optional<Unit> unit_;
  bool has_cloud_ = false;
  std::size_t lost_ = 0;   // when problems were last named
  std::size_t named_ = 0;  // problems
};

}  // namespace

bool is_mcap(const std::string& input) {
  return input.starts_with(scheme) || mcap_input(input).file.extension() == ".mcap";
}

FileTopic mcap_input(const std::string& text) {
  return split_topic(text.starts_with(scheme) ? text.substr(scheme.size()) : text);
}

std::unique_ptr<FrameSource> open_mcap(const FileTopic& from, const std::string& sensor,
                                       std::optional<Unit> unit) {
  return std::make_unique<McapFrames>(from, sensor, unit);
}

bool is_recording(const std::string& input) {
  return is_mcap(input) || std::filesystem::path(input).extension() == ".oni";
}

std::unique_ptr<FrameSource> open_frame_source(const std::string& input, const std::string& sensor,
                                               std::optional<Unit> unit, std::uint32_t decimation) {
  if (is_mcap(input)) return decimate(open_mcap(mcap_input(input), sensor, unit), decimation);
  const std::filesystem::path path = input;
  if (!std::filesystem::exists(path)) {
    throw std::runtime_error(path.string() + ": there is no such file or folder");
  }
  if (std::filesystem::is_directory(path) || path.extension() == ".pcd") {
    const std::uint64_t most = std::uint64_t{decimation} * decimation * capacity_points;
    return decimate(open_pcd(path, sensor, unit, most), decimation);
  }
  if (path.extension() == ".oni") {
    if (unit) {
      throw UnknownInput("--unit: " + path.string() +
                         " says its unit itself, and is read in metres");
    }
    return decimate(open_oni(path, sensor), decimation);
  }
  throw UnknownInput(path.string() +
                     ": cannot be converted: name a .mcap file, an .oni file, a .pcd file or a "
                     "folder of .pcd files");
}

}  // namespace cleave::recording
