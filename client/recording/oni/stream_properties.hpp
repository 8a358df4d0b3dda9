// SPDX-License-Identifier: BSD-3-Clause
// What an .oni file says of its depth stream, apart from the frames.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "recording/oni/depth_codec.hpp"

namespace cleave::oni {

// The part of the sensor's image that was recorded, in pixels.
struct Cropping {
  std::uint32_t x = 0;
  std::uint32_t y = 0;
};

struct DepthStream {
  std::uint32_t width = 0;         // of a recorded image, in pixels
  std::uint32_t height = 0;        // of a recorded image, in pixels
  std::uint32_t sensor_width = 0;  // of the image that the fields of view are of, in pixels
  std::uint32_t sensor_height = 0;
  Cropping cropping;              // where in that image the recorded one begins
  std::uint32_t fps = 0;          // 0 = not told
  double horizontal_fov_rad = 0;  // 0 = not told
  double vertical_fov_rad = 0;    // 0 = not told
  float unit_m = 1e-3F;           // of a depth of 1: 0.001 or 0.0001
  bool mirrored = false;          // left and right are swapped
};

// Collects the properties of one stream, in the order of the file.
class StreamProperties {
 public:
  explicit StreamProperties(std::uint32_t codec) : codec_(codec) {}

  // The fields of a property record, or the start of them. What is of no interest, or not as it
  // should be, is passed over.
  void add(std::span<const std::uint8_t> fields);
  // What is known now. Throws std::runtime_error for what is missing or cannot be read as depth.
  [[nodiscard]] DepthStream stream() const;
  [[nodiscard]] Codec codec() const;

 private:
  void add_fov_of_old_files(double plane_distance, double pixel_size, double ratio);

  std::uint32_t codec_;
  std::uint64_t pixel_format_ = 100;  // OpenNI 1 knew only millimetres
  DepthStream stream_;
  std::optional<Cropping> cropped_size_;
};

}  // namespace cleave::oni
