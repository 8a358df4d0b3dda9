#include "cleave/cloud/pcd_cloud.hpp"

#include <algorithm>
#include <cstring>

#include "cleave/cloud/pcl_reader.hpp"
#include "cleave/cloud/viewpoint.hpp"

namespace cleave::client {
namespace {

constexpr const char* label_name = "label";

// Byte offset of a field in a point.
std::size_t offset_of(const PcdHeader& header, std::size_t field) {
  std::size_t offset = 0;
  for (std::size_t i = 0; i < field; ++i) offset += header.fields[i].bytes();
  return offset;
}

std::string names_of(const PcdHeader& header) {
  std::string names;
  for (const PcdField& field : header.fields) names += " " + field.name;
  return names;
}

template <class Number>
void copy_coordinate(std::span<const std::uint8_t> data, std::size_t offset, std::size_t step,
                     float* to) {
  for (std::size_t at = offset; at < data.size(); at += step, to += 3) {
    Number value;
    std::memcpy(&value, &data[at], sizeof(value));
    *to = static_cast<float>(value);
  }
}

std::vector<float> xyz_of(const std::filesystem::path& file, const PcdHeader& header,
                          std::span<const std::uint8_t> data) {
  std::vector<float> xyz(header.points() * 3);
  const std::size_t step = header.point_bytes();
  std::size_t axis = 0;
  for (const char* name : {"x", "y", "z"}) {
    const auto field = header.find(name);
    if (!field || header.fields[*field].type != 'F' || header.fields[*field].count != 1) {
      throw PcdError(file.string() + ": has no field " + name +
                     " of one floating-point number; its fields are" + names_of(header));
    }
    const std::size_t offset = offset_of(header, *field);
    if (header.fields[*field].size == sizeof(float)) {
      copy_coordinate<float>(data, offset, step, &xyz[axis]);
    } else {
      copy_coordinate<double>(data, offset, step, &xyz[axis]);
    }
    ++axis;
  }
  return xyz;
}

}  // namespace

PcdCloud PcdCloud::read(const std::filesystem::path& file) {
  PcdCloud cloud;
  cloud.file_ = file;
  cloud.header_ = read_pcd_header(file);
  check_pcd_data(file, cloud.header_);
  cloud.data_ = read_points_with_pcl(file, cloud.header_);
  std::erase_if(cloud.header_.fields, [](const PcdField& field) { return field.name == "_"; });
  cloud.xyz_ = xyz_of(file, cloud.header_, cloud.data_);
  return cloud;
}

PcdCloud PcdCloud::of_points(std::span<const float> xyz, std::uint32_t width,
                             std::uint32_t height) {
  PcdCloud cloud;
  for (const char* name : {"x", "y", "z"}) {
    cloud.header_.fields.push_back({name, 'F', sizeof(float), 1});
  }
  cloud.header_.width = width;
  cloud.header_.height = height;
  cloud.header_.encoding = PcdEncoding::binary;
  cloud.xyz_.assign(xyz.begin(), xyz.end());
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(xyz.data());
  cloud.data_.assign(bytes, bytes + xyz.size_bytes());
  return cloud;
}

segmentation::CloudView PcdCloud::view() const {
  segmentation::CloudView view{
      .xyz = xyz_.data(), .stride = 3, .width = header_.width, .height = header_.height};
  view.pose = pose_of_header(header_.viewpoint);
  return view;
}

std::vector<std::uint32_t> PcdCloud::labels() const {
  const auto field = header_.find(label_name);
  if (!field) return {};
  const PcdField& description = header_.fields[*field];
  if (description.type != 'U' || description.bytes() != sizeof(std::uint32_t)) {
    throw PcdError(file_.string() +
                   ": its field label is not one unsigned number of 4 bytes a point; convert the "
                   "labels, or leave the field out");
  }
  const std::size_t step = header_.point_bytes();
  std::vector<std::uint32_t> labels(header_.points());
  std::size_t at = offset_of(header_, *field);
  for (std::uint32_t& label : labels) {
    std::memcpy(&label, &data_[at], sizeof(label));
    at += step;
  }
  return labels;
}

void PcdCloud::set_labels(std::span<const std::uint16_t> labels) {
  const std::size_t field = header_.find(label_name).value_or(header_.fields.size());
  const bool replaces = field < header_.fields.size();
  const std::size_t before = offset_of(header_, field);
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

}  // namespace cleave::client
