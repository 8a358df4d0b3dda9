// SPDX-License-Identifier: BSD-3-Clause
#include "recording/oni/stream_properties.hpp"

#include <cmath>
#include <stdexcept>
#include <string_view>

#include "recording/oni/text.hpp"

namespace cleave::oni {
namespace {

using recording::ByteSource;

constexpr std::uint64_t millimetres = 100;            // ONI_PIXEL_FORMAT_DEPTH_1_MM
constexpr std::uint64_t tenths_of_millimetres = 101;  // ONI_PIXEL_FORMAT_DEPTH_100_UM
constexpr std::uint32_t largest_side = 4096;

bool is_angle(double rad) {
  return rad > 0 && rad < 3.14;  // false for NaN
}

}  // namespace

void StreamProperties::add(std::span<const std::uint8_t> fields) {
  ByteSource bytes(std::as_bytes(fields));
  const auto name = take_text(bytes);
  const auto size = bytes.try_number<std::uint32_t>();
  if (!name || !size) return;
  const auto value = bytes.try_take(*size);
  if (!value) return;
  ByteSource data(*value);
  const auto integer = [&data] { return data.try_number<std::uint64_t>(); };
  if (*name == "oniPixelFormat") {
    if (const auto format = integer()) pixel_format_ = *format;
  } else if (*name == "xnMirror") {
    if (const auto mirrored = integer()) stream_.mirrored = *mirrored != 0;
  } else if (*name == "xnMapOutputMode") {
    const auto width = data.try_number<std::uint32_t>();
    const auto height = data.try_number<std::uint32_t>();
    const auto fps = data.try_number<std::uint32_t>();
    if (!fps) return;
    stream_.sensor_width = *width;
    stream_.sensor_height = *height;
    stream_.fps = *fps;
  } else if (*name == "xnFOV") {
    const auto horizontal = data.try_number<double>();
    const auto vertical = data.try_number<double>();
    if (!vertical) return;
    stream_.horizontal_fov_rad = *horizontal;
    stream_.vertical_fov_rad = *vertical;
  } else if (*name == "xnRealWorldTranslationData") {
    const auto distance = data.try_number<double>();
    const auto pixel = data.try_number<double>();
    const auto ratio = data.try_number<double>();
    if (ratio) add_fov_of_old_files(*distance, *pixel, *ratio);
  } else if (*name == "xnCropping") {
    const auto enabled = data.try_number<std::uint32_t>();
    const auto x = data.try_number<std::uint16_t>();
    const auto y = data.try_number<std::uint16_t>();
    const auto width = data.try_number<std::uint16_t>();
    const auto height = data.try_number<std::uint16_t>();
    if (!height || *enabled == 0) return;
    stream_.cropping = {*x, *y};
    cropped_size_ = {*width, *height};
  }
}

// Files of OpenNI before 1.0.1 tell the sensor's geometry instead of its fields of view.
void StreamProperties::add_fov_of_old_files(double plane_distance, double pixel_size,
                                            double ratio) {
  const auto fov = [&](std::uint32_t pixels) {
    return 2 * std::atan(pixel_size * ratio * pixels / 2 / plane_distance);
  };
  stream_.horizontal_fov_rad = fov(stream_.sensor_width);
  stream_.vertical_fov_rad = fov(stream_.sensor_height);
}

DepthStream StreamProperties::stream() const {
  DepthStream stream = stream_;
  if (pixel_format_ != millimetres && pixel_format_ != tenths_of_millimetres) {
    throw std::runtime_error("its depth is in the pixel format " + std::to_string(pixel_format_) +
                             ", not in millimetres (100) or tenths of them (101): record it anew "
                             "in one of those");
  }
  if (pixel_format_ == tenths_of_millimetres) stream.unit_m = 1e-4F;
  const auto is_side = [](std::uint32_t pixels) { return pixels > 0 && pixels <= largest_side; };
  if (!is_side(stream.sensor_width) || !is_side(stream.sensor_height)) {
    throw std::runtime_error("it does not tell the size of its images, or a wrong one (" +
                             std::to_string(stream.sensor_width) + " x " +
                             std::to_string(stream.sensor_height) + ")");
  }
  stream.width = cropped_size_ ? cropped_size_->x : stream.sensor_width;
  stream.height = cropped_size_ ? cropped_size_->y : stream.sensor_height;
  if (stream.width == 0 || stream.cropping.x + stream.width > stream.sensor_width ||
      stream.height == 0 || stream.cropping.y + stream.height > stream.sensor_height) {
    throw std::runtime_error("its images are cropped to more than there is");
  }
  if (!is_angle(stream.horizontal_fov_rad) || !is_angle(stream.vertical_fov_rad)) {
    stream.horizontal_fov_rad = stream.vertical_fov_rad = 0;
  }
  static_cast<void>(codec());
  return stream;
}

Codec StreamProperties::codec() const {
  if (const std::optional<Codec> codec = codec_of(codec_)) return *codec;
  throw std::runtime_error("its depth is compressed by '" + name_of_codec(codec_) +
                           "', which is not one of NONE, 16zP, 16zT");
}

}  // namespace cleave::oni
