// SPDX-License-Identifier: BSD-3-Clause
#include "recording/frames/ros_messages.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "recording/cdr/cdr.hpp"
#include "recording/time_units.hpp"

namespace cleave::recording {
namespace {

constexpr char depth_encoding[] = "16UC1";
constexpr std::uint8_t float32 = 7;  // of PointField
constexpr std::uint32_t point_step = 3 * sizeof(float);
constexpr std::array<const char*, 3> axes = {"x", "y", "z"};

// std_msgs/Header. A time before 1970 has negative seconds and positive nanoseconds.
void write_stamp(CdrWriter& cdr, const FrameHeader& header) {
  const std::int64_t ns = ((header.capture_time_ns % ns_per_s) + ns_per_s) % ns_per_s;
  cdr.number(static_cast<std::int32_t>((header.capture_time_ns - ns) / ns_per_s));
  cdr.number(static_cast<std::uint32_t>(ns));
  cdr.string(header.coordinate_frame);
}

void skip_stamp(CdrReader& cdr) {
  (void)cdr.number<std::int32_t>();
  (void)cdr.number<std::uint32_t>();
  (void)cdr.string();
}

template <class Number>
std::vector<Number> copy_of(ByteView bytes) {
  std::vector<Number> result(bytes.size() / sizeof(Number));
  if (!result.empty()) std::memcpy(result.data(), bytes.data(), result.size() * sizeof(Number));
  return result;
}

void expect(bool holds, const char* what) {
  if (!holds) throw DataError(what);
}

}  // namespace

Bytes image_message(const FrameHeader& header, std::span<const std::uint16_t> pixels) {
  CdrWriter cdr;
  write_stamp(cdr, header);
  cdr.number(header.height);
  cdr.number(header.width);
  cdr.string(depth_encoding);
  cdr.boolean(false);  // not big-endian
  cdr.number(static_cast<std::uint32_t>(header.width * sizeof(std::uint16_t)));
  cdr.numbers(std::span(reinterpret_cast<const std::uint8_t*>(pixels.data()), pixels.size_bytes()));
  return cdr.bytes();
}

ReceivedImage read_image(ByteView message) {
  CdrReader cdr(message);
  skip_stamp(cdr);
  ReceivedImage image{};
  image.height = cdr.number<std::uint32_t>();
  image.width = cdr.number<std::uint32_t>();
  expect(cdr.string() == depth_encoding, "an image is not 16UC1");
  expect(!cdr.boolean(), "an image is big-endian");
  const auto step = cdr.number<std::uint32_t>();
  const ByteView data = cdr.numbers<std::uint8_t>();
  expect(step == std::uint64_t{image.width} * sizeof(std::uint16_t) &&
             data.size() == std::uint64_t{step} * image.height,
         "an image's data is not of its size");
  image.pixels = copy_of<std::uint16_t>(data);
  return image;
}

Bytes camera_info_message(const FrameHeader& header, const Intrinsics& intrinsics) {
  const double fx{intrinsics.fx};
  const double fy{intrinsics.fy};
  const double cx{intrinsics.cx};
  const double cy{intrinsics.cy};
  CdrWriter cdr;
  write_stamp(cdr, header);
  cdr.number(header.height);
  cdr.number(header.width);
  cdr.string("plumb_bob");
  cdr.length(5);
  for (int i = 0; i < 5; ++i) cdr.number(0.0);
  for (const double k : {fx, 0.0, cx, 0.0, fy, cy, 0.0, 0.0, 1.0}) cdr.number(k);
  for (const double r : {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}) cdr.number(r);
  for (const double p : {fx, 0.0, cx, 0.0, 0.0, fy, cy, 0.0, 0.0, 0.0, 1.0, 0.0}) cdr.number(p);
  for (int i = 0; i < 2 + 4; ++i) cdr.number(std::uint32_t{0});  // binning, region of interest
  cdr.boolean(false);
  return cdr.bytes();
}

Intrinsics read_camera_info(ByteView message) {
  CdrReader cdr(message);
  skip_stamp(cdr);
  (void)cdr.number<std::uint32_t>();
  (void)cdr.number<std::uint32_t>();
  (void)cdr.string();
  const std::size_t distortion = cdr.length(sizeof(double));
  for (std::size_t i = 0; i < distortion; ++i) (void)cdr.number<double>();
  std::array<double, 9> k{};
  for (double& value : k) value = cdr.number<double>();
  return {static_cast<float>(k[0]), static_cast<float>(k[4]), static_cast<float>(k[2]),
          static_cast<float>(k[5])};
}

Bytes point_cloud_message(const Cloud& cloud) {
  CdrWriter cdr;
  write_stamp(cdr, cloud.header);
  cdr.number(cloud.header.height);
  cdr.number(cloud.header.width);
  cdr.length(axes.size());
  for (std::uint32_t i = 0; i < axes.size(); ++i) {
    cdr.string(axes.at(i));
    cdr.number(static_cast<std::uint32_t>(i * sizeof(float)));
    cdr.number(float32);
    cdr.number(std::uint32_t{1});
  }
  cdr.boolean(false);  // not big-endian
  cdr.number(point_step);
  cdr.number(point_step * cloud.header.width);
  cdr.numbers(std::span(reinterpret_cast<const std::uint8_t*>(cloud.xyz.data()),
                        cloud.xyz.size() * sizeof(float)));
  cdr.boolean(std::ranges::none_of(cloud.xyz, [](float x) { return std::isnan(x); }));
  return cdr.bytes();
}

std::vector<float> read_point_cloud(ByteView message) {
  CdrReader cdr(message);
  skip_stamp(cdr);
  const auto height = cdr.number<std::uint32_t>();
  const auto width = cdr.number<std::uint32_t>();
  expect(cdr.length(1) == axes.size(), "a point cloud has other fields than x, y, z");
  for (std::uint32_t i = 0; i < axes.size(); ++i) {
    const bool same = cdr.string() == axes.at(i) &&
                      cdr.number<std::uint32_t>() == i * sizeof(float) &&
                      cdr.number<std::uint8_t>() == float32 && cdr.number<std::uint32_t>() == 1;
    expect(same, "a point cloud has other fields than x, y, z");
  }
  expect(!cdr.boolean(), "a point cloud is big-endian");
  expect(cdr.number<std::uint32_t>() == point_step, "a point cloud's points are not 12 bytes");
  (void)cdr.number<std::uint32_t>();  // follows from the rest
  const ByteView data = cdr.numbers<std::uint8_t>();
  expect(data.size() == std::uint64_t{width} * height * point_step,
         "a point cloud's data is not of its size");
  return copy_of<float>(data);
}

}  // namespace cleave::recording
