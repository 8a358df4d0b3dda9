// SPDX-License-Identifier: BSD-3-Clause
// What a PCD file says about itself, checked for sense.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recording/pcd/input.hpp"

namespace cleave::recording {

struct PcdField {
  std::string name;     // "_" is padding
  char type;            // I signed, U unsigned, F floating point
  std::uint32_t size;   // bytes of one element: 1, 2, 4 or 8
  std::uint32_t count;  // elements a point; 0 = takes no bytes
  [[nodiscard]] std::size_t bytes() const { return std::size_t{size} * count; }
  [[nodiscard]] bool is_padding() const { return name == "_"; }
};

enum class PcdEncoding { ascii, binary, binary_compressed };

struct PcdHeader {
  std::vector<PcdField> fields;
  std::uint32_t width = 0;
  std::uint32_t height = 0;  // 1 = unorganised
  // VIEWPOINT, if the file has one: translation x y z and quaternion w x y z, all finite.
  std::optional<std::array<double, 7>> viewpoint;
  PcdEncoding encoding = PcdEncoding::ascii;

  [[nodiscard]] std::uint64_t points() const { return std::uint64_t{width} * height; }
  [[nodiscard]] std::size_t point_bytes() const;
  [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const;
  [[nodiscard]] std::size_t offset_of(std::size_t field) const;  // bytes before it in a point
};

// Reads the header and leaves `input` at the points. Takes PCD 0.5 to 0.7 as PCL does: COUNT, SIZE
// with TYPE (then 4 and F), HEIGHT, VIEWPOINT, and either POINTS or WIDTH may be missing. Checks
// known sizes and types, as many of each as there are fields, one number each named x, y and z, no
// other name twice, width * height = points, at least one point. Throws PcdError.
[[nodiscard]] PcdHeader read_pcd_header(PcdInput& input);

}  // namespace cleave::recording
