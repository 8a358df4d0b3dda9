// SPDX-License-Identifier: BSD-3-Clause
#include "config/grabber_config.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "idl/capacity.hpp"

namespace cleave::config {
namespace {

constexpr std::size_t max_frame_name_length = 63;  // char coordinate_frame[64] in the contract
constexpr std::string_view frame_suffix = "_optical";

VideoConfig read_video_config(Section& file, const ImageSize& instead, std::uint32_t decimate) {
  VideoConfig config;
  Section section = file.section("video");
  section.integer("width", config.width, 16, 4096);
  section.integer("height", config.height, 16, 4096);
  config.width = instead.width.value_or(config.width);
  config.height = instead.height.value_or(config.height);
  if (std::uint64_t{config.width / decimate} * (config.height / decimate) > capacity_points) {
    section.refuse("height", "at most " + std::to_string(capacity_points) + " (" + capacity_text() +
                                 ") pixels in all, once decimated");
  }
  section.boolean("registration", config.registration);
  section.boolean("mirror", config.mirror);
  return config;
}

bool is_frame_name(const std::string& name) {
  return name.size() <= max_frame_name_length &&
         std::all_of(name.begin(), name.end(), [](char c) { return c > ' ' && c <= '~'; });
}

void read_intrinsics(Section& section, CalibrationConfig& config) {
  section.number("fx", config.fx, 0, 100'000);
  section.number("fy", config.fy, 0, 100'000);
  section.number("cx", config.cx, -100'000, 100'000);
  section.number("cy", config.cy, -100'000, 100'000);
  const bool none = config.fx == 0 && config.fy == 0 && config.cx == 0 && config.cy == 0;
  if (!none && config.fx == 0) section.refuse("fx", "all of fx, fy, cx and cy, or none");
  if (!none && config.fy == 0) section.refuse("fy", "all of fx, fy, cx and cy, or none");
}

void read_pose(Section& section, CalibrationConfig& config) {
  constexpr double far_m = 1e6;
  section.text("parent_frame", config.parent_frame);
  if (!is_frame_name(config.parent_frame)) {
    section.refuse("parent_frame", "at most 63 printable ASCII characters without blanks");
  }
  Section position = section.section("position");
  position.number("x", config.position.x, -far_m, far_m);
  position.number("y", config.position.y, -far_m, far_m);
  position.number("z", config.position.z, -far_m, far_m);
  Section orientation = section.section("orientation");
  auto& [x, y, z, w] = config.orientation;
  orientation.number("x", x, -1, 1);
  orientation.number("y", y, -1, 1);
  orientation.number("z", z, -1, 1);
  orientation.number("w", w, -1, 1);
  const float length = std::sqrt(x * x + y * y + z * z + w * w);
  const bool known = length != 0;
  if (known && std::abs(length - 1) > 0.01F) {
    section.refuse("orientation", "a quaternion of unit length, or all 0");
  }
  if (!known && (config.position.x != 0 || config.position.y != 0 || config.position.z != 0)) {
    section.refuse("position", "an orientation beside it; {w: 1} turns nothing");
  }
  if (known == config.parent_frame.empty()) {
    section.refuse("parent_frame", "parent_frame and orientation both, or neither");
  }
  if (!known) return;
  for (float* const part : {&x, &y, &z, &w}) *part /= length;
}

CalibrationConfig read_calibration(Section& file) {
  CalibrationConfig config;
  Section section = file.section("calibration");
  read_intrinsics(section, config);
  section.number("depth_scale", config.depth_scale, 0.5, 2);
  read_pose(section, config);
  return config;
}

bool is_unit(const std::string& name) {
  return name.empty() || name == "m" || name == "cm" || name == "mm";
}

}  // namespace

GrabberConfig load_grabber_config(const std::filesystem::path& path, const ImageSize& instead) {
  GrabberConfig config;
  Section file = Section::load(path);
  file.text("sensor", config.sensor);
  check_sensor_name(file, "sensor", config.sensor);
  file.text("coordinate_frame", config.coordinate_frame);
  if (!is_frame_name(config.coordinate_frame)) {
    file.refuse("coordinate_frame", "at most 63 printable ASCII characters without blanks");
  }
  file.text("source", config.source);
  file.text("unit", config.unit);
  if (!is_unit(config.unit)) file.refuse("unit", "m, cm, mm, or \"\"");
  file.integer("fps", config.fps, 1, 240);
  file.number("max_gap_s", config.max_gap_s, 0, 86'400);
  file.integer("decimate", config.decimate, 1, 4);
  config.decimate = instead.decimate.value_or(config.decimate);
  file.boolean("loop", config.loop);
  read_mode(file, config.mode);
  file.integer("window", config.window, 1, 4);
  config.video = read_video_config(file, instead, config.decimate);
  config.calibration = read_calibration(file);
  config.stream = read_stream_config(file);
  file.finish();
  return config;
}

// A sensor name of 56 characters and more leaves no room for the whole suffix.
std::string coordinate_frame_of(const GrabberConfig& config) {
  if (!config.coordinate_frame.empty()) return config.coordinate_frame;
  return (config.sensor + std::string(frame_suffix)).substr(0, max_frame_name_length);
}

}  // namespace cleave::config
