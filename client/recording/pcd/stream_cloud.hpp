// SPDX-License-Identifier: BSD-3-Clause
// A PCD file as a sensor would have sent it.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "recording/cloud/projection.hpp"
#include "recording/units/unit.hpp"

namespace cleave::recording {

struct StreamCloud {
  std::uint32_t width = 0;
  std::uint32_t height = 0;        // 1 = unorganised
  std::vector<float> xyz;          // width * height points, row-major, NaN NaN NaN = no measurement
  Intrinsics intrinsics;           // of an organised cloud, where they explain its points; else 0
  std::array<double, 3> origin{};  // to be added to xyz for the file's coordinates, in metres
};

// The points are PcdCloud's, bit for bit, but that one that is no measurement (is_measured) becomes
// NaN NaN NaN, and that those in another `unit` are scaled to metres. Other fields are passed over.
// One for the grabber and for `convert`, which must agree about every bit. Throws PcdError, also
// for more than `most_points`; WrongUnit where no unit is given and the file seems to be in
// millimetres.
[[nodiscard]] StreamCloud read_stream_cloud(const std::filesystem::path& file,
                                            std::uint64_t most_points,
                                            std::optional<Unit> unit = {});

}  // namespace cleave::recording
