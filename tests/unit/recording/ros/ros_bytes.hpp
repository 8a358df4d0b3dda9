// SPDX-License-Identifier: BSD-3-Clause
// Messages of ROS byte by byte, without a line of the library's own serialisation.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "recording/mcap/bytes.hpp"
#include "recording/mcap/writer.hpp"

namespace cleave::recording::ros {

enum class Format { cdr_le, cdr_be, ros1 };

class RosBytes {
 public:
  explicit RosBytes(Format format);
  RosBytes& u8(std::uint8_t value);
  RosBytes& u32(std::uint32_t value);
  RosBytes& f64(double value);
  RosBytes& text(const std::string& text);
  RosBytes& bytes(const Bytes& data);  // with its length
  RosBytes& header(std::int64_t stamp_ns, const std::string& frame_id = "camera_optical");
  [[nodiscard]] const Bytes& result() const { return bytes_; }

 private:
  template <class Number>
  RosBytes& number(Number value);
  Format format_;
  Bytes bytes_;
};

struct Field {
  std::string name;
  std::uint32_t offset;
  std::uint8_t datatype;
  std::uint32_t count = 1;
};

struct CloudSpec {
  std::uint32_t width = 4;
  std::uint32_t height = 1;
  std::vector<Field> fields = {{"x", 0, 7}, {"y", 4, 7}, {"z", 8, 7}};
  bool big_endian = false;
  std::uint32_t point_step = 12;
  std::uint32_t row_step = 48;
  Bytes data = Bytes(48);
  std::int64_t stamp_ns = 1'700'000'000'500'000'000;
};
[[nodiscard]] Bytes bytes_of_cloud(const CloudSpec& cloud, Format format = Format::cdr_le);
// Of float32 x, y, z without gaps.
[[nodiscard]] CloudSpec cloud_of(const std::vector<float>& xyz, std::uint32_t width,
                                 std::uint32_t height);

struct ImageSpec {
  std::uint32_t width = 3;
  std::uint32_t height = 2;
  std::string encoding = "16UC1";
  bool big_endian = false;
  std::uint32_t step = 6;
  Bytes data = Bytes(12);
  std::int64_t stamp_ns = 1'700'000'000'500'000'000;
};
[[nodiscard]] Bytes bytes_of_image(const ImageSpec& image, Format format = Format::cdr_le);

struct CameraSpec {
  std::uint32_t width = 3;
  std::uint32_t height = 2;
  std::vector<double> k = {50, 0, 1, 0, 40, 0.5, 0, 0, 1};
  std::vector<double> p = {50, 0, 1, 0, 0, 40, 0.5, 0, 0, 0, 1, 0};
  std::vector<double> d = {0, 0, 0, 0, 0};
  std::uint32_t binning_x = 0;
  std::uint32_t binning_y = 0;
  std::uint32_t roi_x = 0;
  std::uint32_t roi_y = 0;
  std::uint32_t roi_height = 0;
  std::uint32_t roi_width = 0;
  std::int64_t stamp_ns = 1'700'000'000'500'000'000;
};
[[nodiscard]] Bytes bytes_of_camera(const CameraSpec& camera, Format format = Format::cdr_le);

// One number as bytes, in either order.
template <class Number>
[[nodiscard]] Bytes bytes_of_number(Number value, bool big_endian) {
  const ByteView plain = std::as_bytes(std::span(&value, 1));
  Bytes bytes(plain.begin(), plain.end());
  if (big_endian) std::ranges::reverse(bytes);
  return bytes;
}

// A bag: each message with its topic, type and time.
class Bag {
 public:
  explicit Bag(const std::filesystem::path& file, std::string encoding = "cdr")
      : writer_(file), encoding_(std::move(encoding)) {}
  Bag& add(const std::string& topic, const std::string& type, std::int64_t log_ns,
           const Bytes& message);
  void close() { writer_.close(); }

 private:
  McapWriter writer_;
  std::string encoding_;
  std::map<std::string, std::uint16_t> schemas_;
  std::map<std::string, std::uint16_t> channels_;
};

inline constexpr char cloud_type[] = "sensor_msgs/msg/PointCloud2";
inline constexpr char image_type[] = "sensor_msgs/msg/Image";
inline constexpr char camera_type[] = "sensor_msgs/msg/CameraInfo";

}  // namespace cleave::recording::ros
