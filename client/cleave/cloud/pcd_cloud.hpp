// A PCD file in memory, with all of its fields, whatever they are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "cleave/cloud/pcd_header.hpp"
#include "segmentation/cloud_view.hpp"

namespace cleave::client {

class PcdCloud {
 public:
  // Throws PcdError when the file cannot be read, its header and its data disagree, or it has no
  // x, y, z of floating point. Never allocates more than the file's size justifies.
  [[nodiscard]] static PcdCloud read(const std::filesystem::path& file);

  // A cloud of nothing but points, to be written as `binary`: 3 floats each, `width` * `height`.
  [[nodiscard]] static PcdCloud of_points(std::span<const float> xyz, std::uint32_t width,
                                          std::uint32_t height);

  [[nodiscard]] const PcdHeader& header() const { return header_; }
  // x, y, z of every point in metres, in the file's order, and the header's VIEWPOINT; lives as
  // long as this.
  [[nodiscard]] segmentation::CloudView view() const;

  // The bytes of all points one after the other, fields in the header's order, padding left out.
  [[nodiscard]] std::span<const std::uint8_t> data() const { return data_; }

  // The field `label`, one value a point; empty if there is none. Throws PcdError if it is anything
  // but one uint32.
  [[nodiscard]] std::vector<std::uint32_t> labels() const;
  // Writes the field `label` (uint32), one value a point: in the place of a field of that name, of
  // whatever type, or else behind the last field. Nothing else changes.
  void set_labels(std::span<const std::uint16_t> labels);

 private:
  PcdCloud() = default;
  std::filesystem::path file_;
  PcdHeader header_;
  std::vector<std::uint8_t> data_;
  std::vector<float> xyz_;
};

}  // namespace cleave::client
