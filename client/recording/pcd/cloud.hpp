// SPDX-License-Identifier: BSD-3-Clause
// A PCD file in memory, with all of its fields, whatever they are.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "recording/pcd/coordinates.hpp"
#include "recording/pcd/header.hpp"

namespace cleave::recording {

// Where the sensor was: in the file's coordinates, before the cloud's origin is taken off.
struct SensorPose {
  std::array<double, 3> position{};
  std::array<double, 4> orientation{1, 0, 0, 0};  // quaternion w x y z of length 1
};

class PcdCloud {
 public:
  // Throws PcdError when the file cannot be read, its header and its data disagree, it has no x, y
  // and z, or more than `most_points` or 1 GiB of points. Never allocates more than the file's size
  // justifies.
  [[nodiscard]] static PcdCloud read(
      const std::filesystem::path& file,
      std::uint64_t most_points = std::numeric_limits<std::uint64_t>::max());

  // A cloud of nothing but points, to be written: 3 floats each, `width` * `height`.
  [[nodiscard]] static PcdCloud of_points(std::span<const float> xyz, std::uint32_t width,
                                          std::uint32_t height,
                                          PcdEncoding encoding = PcdEncoding::binary);

  // Its fields are without padding.
  [[nodiscard]] const PcdHeader& header() const { return header_; }
  // x, y, z of every point in the file's order and unit, relative to origin(); what the file says
  // is no number or 0 0 0 stays that (but see origin()). Lives as long as this.
  [[nodiscard]] std::span<const float> xyz() const { return coordinates_.xyz; }
  // What to add to xyz() for the file's coordinates; 0 0 0 unless these are doubles or large
  // integers far from zero (coordinates.hpp).
  [[nodiscard]] const std::array<double, 3>& origin() const { return coordinates_.origin; }
  // What VIEWPOINT says; nothing if it is missing, has a quaternion of length 0, or is the default
  // 0 0 0 1 0 0 0, which writers that know nothing put there.
  [[nodiscard]] std::optional<SensorPose> sensor_pose() const;

  // The bytes of all points one after the other, fields in the header's order.
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
  Coordinates coordinates_;
};

}  // namespace cleave::recording
