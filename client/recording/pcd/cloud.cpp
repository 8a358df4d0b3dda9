// SPDX-License-Identifier: BSD-3-Clause
#include "recording/pcd/cloud.hpp"

#include <cmath>
#include <cstring>
#include <string>

#include "recording/pcd/encoding/body.hpp"

namespace cleave::recording {
namespace {

constexpr const char* label_name = "label";
constexpr std::uint64_t most_bytes = std::uint64_t{1} << 30U;

void check_size(const PcdInput& input, const PcdHeader& header, std::uint64_t most_points) {
  const std::string promise = "the header promises " + std::to_string(header.points()) + " points";
  if (header.points() > most_points) {
    input.refuse(PcdCause::too_many_points, promise + ", " + std::to_string(header.width) + " x " +
                                                std::to_string(header.height) + ", where at most " +
                                                std::to_string(most_points) +
                                                " fit; crop the cloud, or thin it out (--decimate "
                                                "2 makes four points of an image into one)");
  }
  if (header.points() > most_bytes / header.point_bytes()) {
    input.refuse(PcdCause::too_many_points,
                 promise + " of " + std::to_string(header.point_bytes()) +
                     " bytes, more than 1 GiB in all; split the cloud, or thin it out");
  }
}

std::vector<std::uint8_t> read_body(PcdInput& input, const PcdHeader& header) {
  switch (header.encoding) {
    case PcdEncoding::ascii:
      return read_ascii(input, header);
    case PcdEncoding::binary:
      return read_binary(input, header);
    case PcdEncoding::binary_compressed:
      return read_compressed(input, header);
  }
  return {};
}

}  // namespace

PcdCloud PcdCloud::read(const std::filesystem::path& file, std::uint64_t most_points) {
  PcdInput input(file);
  PcdCloud cloud;
  cloud.file_ = file;
  cloud.header_ = read_pcd_header(input);
  check_size(input, cloud.header_, most_points);
  cloud.data_ = read_body(input, cloud.header_);
  cloud.header_.fields = without_padding(std::move(cloud.header_.fields));
  cloud.coordinates_ = coordinates_of(cloud.header_, cloud.data_);
  return cloud;
}

PcdCloud PcdCloud::of_points(std::span<const float> xyz, std::uint32_t width, std::uint32_t height,
                             PcdEncoding encoding) {
  PcdCloud cloud;
  for (const char* name : {"x", "y", "z"}) {
    cloud.header_.fields.push_back({name, 'F', sizeof(float), 1});
  }
  cloud.header_.width = width;
  cloud.header_.height = height;
  cloud.header_.encoding = encoding;
  cloud.coordinates_.xyz.assign(xyz.begin(), xyz.end());
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(xyz.data());
  cloud.data_.assign(bytes, bytes + xyz.size_bytes());
  return cloud;
}

std::optional<SensorPose> PcdCloud::sensor_pose() const {
  constexpr std::array<double, 7> unknown = {0, 0, 0, 1, 0, 0, 0};
  if (!header_.viewpoint || *header_.viewpoint == unknown) return std::nullopt;
  const auto& [x, y, z, qw, qx, qy, qz] = *header_.viewpoint;
  const double length = std::sqrt(qw * qw + qx * qx + qy * qy + qz * qz);
  if (!std::isnormal(length)) return std::nullopt;
  return SensorPose{{x, y, z}, {qw / length, qx / length, qy / length, qz / length}};
}

std::vector<std::uint32_t> PcdCloud::labels() const {
  const auto field = header_.find(label_name);
  if (!field) return {};
  const PcdField& description = header_.fields[*field];
  if (description.type != 'U' || description.bytes() != sizeof(std::uint32_t)) {
    throw PcdError(file_, PcdCause::bad_header,
                   "its field label is not one unsigned number of 4 bytes a point; convert the "
                   "labels, or leave the field out");
  }
  const std::size_t step = header_.point_bytes();
  std::vector<std::uint32_t> labels(header_.points());
  std::size_t at = header_.offset_of(*field);
  for (std::uint32_t& label : labels) {
    std::memcpy(&label, &data_[at], sizeof(label));
    at += step;
  }
  return labels;
}

void PcdCloud::set_labels(std::span<const std::uint16_t> labels) {
  const std::size_t field = header_.find(label_name).value_or(header_.fields.size());
  const bool replaces = field < header_.fields.size();
  const std::size_t before = header_.offset_of(field);
  const std::size_t replaced = replaces ? header_.fields[field].bytes() : 0;
  const std::size_t step = header_.point_bytes();

  std::vector<std::uint8_t> data;
  data.reserve(header_.points() * (step - replaced + sizeof(std::uint32_t)));
  for (std::size_t i = 0; i < header_.points(); ++i) {
    const std::uint32_t label = labels[i];
    const auto* label_bytes = reinterpret_cast<const std::uint8_t*>(&label);
    const auto point = std::span(data_).subspan(i * step, step);
    const auto behind = point.subspan(before + replaced);
    data.insert(data.end(), point.begin(), point.begin() + static_cast<std::ptrdiff_t>(before));
    data.insert(data.end(), label_bytes, label_bytes + sizeof(label));
    data.insert(data.end(), behind.begin(), behind.end());
  }
  data_ = std::move(data);

  if (!replaces) header_.fields.emplace_back();
  header_.fields[field] = {label_name, 'U', sizeof(std::uint32_t), 1};
}

}  // namespace cleave::recording
