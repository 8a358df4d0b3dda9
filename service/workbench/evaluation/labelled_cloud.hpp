// SPDX-License-Identifier: BSD-3-Clause
// Clouds with true labels, for whoever judges a segmentation.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "recording/units/unit.hpp"
#include "segmentation/cloud_view.hpp"

namespace cleave::evaluation {

struct LabelledCloud {
  std::uint32_t width = 0;
  std::uint32_t height = 0;          // 1 = unorganised
  std::vector<float> xyz;            // 3 a point, metres
  std::vector<std::uint32_t> label;  // one a point, 0 = none; empty = the cloud has no labels
  std::array<double, 3> origin_m = {0, 0, 0};                   // as in CloudView
  std::optional<segmentation::SensorPose> pose = std::nullopt;  // as in CloudView

  [[nodiscard]] segmentation::CloudView view() const {
    return {xyz.data(), 3, width, height, origin_m, pose};
  }
  [[nodiscard]] std::size_t size() const { return std::size_t{width} * height; }
  [[nodiscard]] bool labelled() const { return !label.empty(); }
};

// Reads a PCD file with x, y, z and, if it has one, the field `label` (uint32). A point that is no
// measurement has no label whatever the file says. `unit`: of the file; without one it must not
// look like millimetres. Throws PcdError or WrongUnit that names the file and what is wrong with
// it.
[[nodiscard]] LabelledCloud load_cloud(const std::filesystem::path& file,
                                       std::optional<recording::Unit> unit = {});

// The same for a cloud that something is to be judged by: a file without labels, or without one on
// a measured point, is refused as well. Throws std::runtime_error.
[[nodiscard]] LabelledCloud load_labelled_cloud(const std::filesystem::path& file,
                                                std::optional<recording::Unit> unit = {});

}  // namespace cleave::evaluation
