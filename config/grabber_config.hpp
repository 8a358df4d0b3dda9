// SPDX-License-Identifier: BSD-3-Clause
// What cleave-grabber can be told. The file as shipped is grabber.yaml; it holds these defaults.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "config/stream_config.hpp"

namespace cleave::config {

// What is asked of a camera, with the fps below.
struct VideoConfig {
  std::uint32_t width = 640;   // pixels; at most 640 * 480 in all once decimated
  std::uint32_t height = 480;  // pixels
  bool registration = false;   // depth as the camera's colour sensor would see it
  bool mirror = false;         // left and right swapped
};

// What is better known of a camera than its driver reports it.
struct CalibrationConfig {
  // Pinhole intrinsics in pixels of the source's images, before `decimate`; all 0 = the source's.
  float fx = 0, fy = 0, cx = 0, cy = 0;
  float depth_scale = 1;  // 0.5 to 2: what depths are multiplied by
  // Where the sensor is: p_parent = orientation * p + position.
  std::string parent_frame;  // empty = not known
  struct {
    float x = 0, y = 0, z = 0;
  } position;  // metres
  struct {
    float x = 0, y = 0, z = 0, w = 0;
  } orientation;  // unit length; all 0 = not known
};

struct GrabberConfig {
  std::string sensor = "camera";    // names the topics: cleave/<sensor>/cloud
  std::string coordinate_frame;     // of the points; empty = "<sensor>_optical"
  std::string source = "openni2:";  // URI, see sensor/sources/make_source.hpp
  std::string unit;                 // of the points of pcd and mcap: m, cm, mm; empty = not said
  std::uint32_t fps = 30;           // 1 to 240: mode of a camera, pace of recordings
  double max_gap_s = 1;             // 0 to 86400: longest pause between two frames of mcap:
  std::uint32_t decimate = 1;       // 1 to 4: a block of so many pixels a side becomes one
  bool loop = false;                // recordings start again at their end
  Mode mode = Mode::live;
  std::uint32_t window = 4;  // 1 to 4 frames in flight in lossless mode
  VideoConfig video;
  CalibrationConfig calibration;
  StreamConfig stream;
};

// What of a file is checked together, and what a command line says instead of it.
struct ImageSize {
  std::optional<std::uint32_t> width = {}, height = {}, decimate = {};
};

// `instead` of the file's. Throws ConfigurationError.
[[nodiscard]] GrabberConfig load_grabber_config(const std::filesystem::path& file,
                                                const ImageSize& instead = {});

// The frame that the points are in, with the default filled in.
[[nodiscard]] std::string coordinate_frame_of(const GrabberConfig& config);

}  // namespace cleave::config
