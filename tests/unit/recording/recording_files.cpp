// SPDX-License-Identifier: BSD-3-Clause
#include "tests/unit/recording/recording_files.hpp"

#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkdtemp is POSIX's

#include <bit>
#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "recording/frames/frame_reader.hpp"
#include "recording/frames/frame_writer.hpp"

namespace cleave::recording {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr std::int64_t start_ns = 1'700'000'000'000'000'000;
constexpr std::int64_t period_ns = 33'333'333;

}  // namespace

Bytes read_all(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(stream)), {});
  const ByteView bytes = bytes_of(text);
  return {bytes.begin(), bytes.end()};
}

void write_all(const std::filesystem::path& file, ByteView bytes) {
  std::ofstream stream(file, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
}

FrameHeader header(std::uint64_t frame_id, std::uint32_t width, std::uint32_t height) {
  FrameHeader h;
  h.frame_id = frame_id;
  h.epoch = 7;
  h.capture_time_ns = start_ns + static_cast<std::int64_t>(frame_id) * period_ns;
  h.arrival_time_ns = 900 + static_cast<std::int64_t>(frame_id);
  h.publication_time_ns = 1000 + static_cast<std::int64_t>(frame_id);
  h.device_time_us = 33'333 * frame_id;
  h.width = width;
  h.height = height;
  h.sensor = "camera";
  h.coordinate_frame = "camera_optical";
  return h;
}

Cloud depth_cloud(std::uint64_t frame_id, std::uint32_t width, std::uint32_t height) {
  Cloud cloud{header(frame_id, width, height), {}};
  FrameHeader& h = cloud.header;
  h.fx = h.fy = 52.5F;
  h.cx = static_cast<float>(width - 1) / 2;
  h.cy = static_cast<float>(height - 1) / 2;
  for (std::uint32_t v = 0; v < height; ++v) {
    for (std::uint32_t u = 0; u < width; ++u) {
      const auto depth_mm = static_cast<std::uint16_t>(700 + 3 * u + 5 * v + frame_id % 10);
      const bool missing = (u + v) % 5 == 0;
      const float z = missing ? nan : depth_mm * 0.001F;
      cloud.xyz.push_back(static_cast<float>((u - double{h.cx}) / double{h.fx}) * z);
      cloud.xyz.push_back(static_cast<float>((v - double{h.cy}) / double{h.fy}) * z);
      cloud.xyz.push_back(z);
    }
  }
  return cloud;
}

Cloud free_cloud(std::uint64_t frame_id, std::uint32_t points) {
  Cloud cloud{header(frame_id, points, 1), {}};
  for (std::uint32_t i = 0; i < points; ++i) {
    const float x = 0.1F + 0.0123F * static_cast<float>(i);
    for (const float coordinate : {x, -x / 3, 1 / x}) {
      cloud.xyz.push_back(i % 7 == 0 ? nan : coordinate);
    }
  }
  return cloud;
}

Labels labels(std::uint64_t frame_id, std::uint32_t width, std::uint32_t height) {
  Labels labels{header(frame_id, width, height), 555, {}};
  for (std::uint32_t i = 0; i < width * height; ++i) {
    labels.label.push_back(static_cast<std::uint16_t>((i + frame_id) / 100 % 4));
  }
  return labels;
}

SegmentList segment_list(std::uint64_t frame_id) {
  SegmentList list;
  list.header = header(frame_id, 32, 24);
  list.cloud_publication_time_ns = 555;
  list.cloud_reception_time_ns = 777;
  for (std::uint16_t label = 1; label <= 3; ++label) {
    const auto at = static_cast<float>(label);
    list.segments.push_back({label,
                             100U * label,
                             {at, 0.5F, 1.5F},
                             {0, 0, -1},
                             {{at, 0.25F, 1}, {0, 0, 0, 1}, {0.3F, 0.2F, 0.1F}},
                             {1, 2, 3, 4},
                             0.75F});
  }
  list.borders = {{1, 2, BorderKind::concave}, {2, 3, BorderKind::convex}};
  list.queue_ms = 1.5F;
  list.segmentation_ms = 20.25F;
  return list;
}

void write_frames(const std::filesystem::path& file, std::uint64_t count, std::size_t chunk_bytes) {
  FrameWriter writer(file, chunk_bytes);
  for (std::uint64_t id = 1; id <= count; ++id) {
    const std::int64_t time_ns = start_ns + static_cast<std::int64_t>(id) * period_ns;
    writer.write({time_ns, depth_cloud(id)});
    writer.write({time_ns + 10, labels(id)});
    writer.write({time_ns + 20, segment_list(id)});
  }
  writer.close();
}

std::vector<Frame> read_frames(const std::filesystem::path& file) {
  FrameReader reader(file);
  std::vector<Frame> frames;
  while (auto frame = reader.next()) frames.push_back(std::move(*frame));
  return frames;
}

std::optional<std::uint64_t> bytes_read_so_far() {
  std::ifstream counts("/proc/self/io");
  std::string name;
  std::uint64_t value = 0;
  if (counts >> name >> value && name == "rchar:") return value;
  return std::nullopt;
}

bool same_points(const std::vector<float>& a, const std::vector<float>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const bool same = std::bit_cast<std::uint32_t>(a[i]) == std::bit_cast<std::uint32_t>(b[i]);
    if (!same && !(std::isnan(a[i]) && std::isnan(b[i]))) return false;
  }
  return true;
}

}  // namespace cleave::recording
