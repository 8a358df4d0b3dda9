// SPDX-License-Identifier: BSD-3-Clause
// One scene in other storage orders and frames, and how alike its segmentations are.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "segmentation/cloud_view.hpp"
#include "segmentation/view/storage_order.hpp"
#include "tests/unit/segmentation/support/depth_scene.hpp"

namespace cleave::segmentation {

struct Scene {
  std::uint32_t width = 0, height = 0;
  std::vector<float> xyz;
  std::vector<std::size_t> index;  // of each point in the scene that this one was made from

  [[nodiscard]] CloudView view() const { return {xyz.data(), 3, width, height}; }
};

[[nodiscard]] inline Scene scene_of(std::uint32_t width, std::uint32_t height,
                                    std::vector<float> xyz) {
  Scene scene{width, height, std::move(xyz), {}};
  for (std::size_t i = 0; i < scene.view().size(); ++i) scene.index.push_back(i);
  return scene;
}

// All that a camera sees is one plane.
[[nodiscard]] inline Scene tilted_plane() {
  Scene scene = scene_of(160, 120, std::vector<float>(3 * 160 * 120));
  for (std::size_t i = 0; i < scene.index.size(); ++i) {
    const double u = (static_cast<double>(i % scene.width) - 79.5) / 525;
    const double v = (static_cast<double>(i / scene.width) - 59.5) / 525;
    const double z = 1 / (1 + 1.5 * v + 0.3 * u);
    const Eigen::Vector3d point(u * z, v * z, z);
    Eigen::Map<Eigen::Vector3f>(&scene.xyz[3 * i]) = point.cast<float>();
  }
  return scene;
}

// Pixels of the scene for which `column` and `row` are chosen.
template <class ChooseColumn, class ChooseRow>
[[nodiscard]] Scene chosen(const Scene& scene, ChooseColumn&& column_counts,
                           ChooseRow&& row_counts) {
  Scene result;
  for (std::uint32_t row = 0; row < scene.height; ++row) {
    if (!row_counts(row)) continue;
    ++result.height;
    for (std::uint32_t column = 0; column < scene.width; ++column) {
      if (!column_counts(column)) continue;
      const std::size_t i = std::size_t{row} * scene.width + column;
      result.xyz.insert(result.xyz.end(), &scene.xyz[3 * i], &scene.xyz[3 * i] + 3);
      result.index.push_back(scene.index[i]);
    }
  }
  result.width = static_cast<std::uint32_t>(result.index.size() / result.height);
  return result;
}

[[nodiscard]] inline Scene stored(const Scene& scene, StorageOrder order) {
  Scene result = scene;
  if (order.transposed) std::swap(result.width, result.height);
  const UprightImage image(order, result.width, result.height);
  for (std::uint32_t row = 0; row < scene.height; ++row) {
    for (std::uint32_t column = 0; column < scene.width; ++column) {
      const std::size_t from = std::size_t{row} * scene.width + column;
      const std::size_t to = image.index(column, row);
      std::copy_n(&scene.xyz[3 * from], 3, &result.xyz[3 * to]);
      result.index[to] = scene.index[from];
    }
  }
  return result;
}

[[nodiscard]] inline Scene moved(Scene scene, const Eigen::Isometry3d& pose) {
  for (std::size_t i = 0; i < scene.xyz.size(); i += 3) {
    Eigen::Map<Eigen::Vector3f> point(&scene.xyz[i]);
    if (point.isZero(0)) continue;
    point = (pose * point.cast<double>()).cast<float>();
  }
  return scene;
}

// What is in front of a robot's arm: x forward, z up, the camera tilted down.
[[nodiscard]] inline Eigen::Isometry3d camera_on_a_robot() {
  Eigen::Matrix3d axes;
  axes << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translate(Eigen::Vector3d(0.2, 0.1, 1.1));
  pose.rotate(Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitY()));
  pose.rotate(axes);
  return pose;
}

// Share of the points of `part` that lie in the segment in which most of their segment's points
// lie in the other segmentation, whichever of the two is the coarser.
[[nodiscard]] inline double agreement(const std::vector<std::uint16_t>& whole_labels,
                                      const Scene& part,
                                      const std::vector<std::uint16_t>& part_labels) {
  const auto one_way = [&](bool from_whole) {
    std::map<std::pair<int, int>, std::size_t> overlap;
    for (std::size_t i = 0; i < part_labels.size(); ++i) {
      const int a = whole_labels[part.index[i]];
      const int b = part_labels[i];
      ++overlap[from_whole ? std::pair(a, b) : std::pair(b, a)];
    }
    std::map<int, std::size_t> most;
    for (const auto& [labels, count] : overlap) {
      most[labels.first] = std::max(most[labels.first], count);
    }
    std::size_t sum = 0;
    for (const auto& [label, count] : most) sum += count;
    return static_cast<double>(sum) / static_cast<double>(part_labels.size());
  };
  return std::min(one_way(true), one_way(false));
}

inline std::vector<StorageOrder> all_storage_orders() {
  std::vector<StorageOrder> orders;
  for (const bool transposed : {false, true}) {
    for (const bool columns : {false, true}) {
      for (const bool rows : {false, true}) orders.push_back({transposed, columns, rows});
    }
  }
  return orders;
}

// Images whose camera has to be found: boxes, and a plane, in another storage order each.
[[nodiscard]] inline std::vector<Scene> scenes_on_a_robot() {
  std::vector<Scene> scenes;
  for (const StorageOrder& order : all_storage_orders()) {
    const DepthScene boxes(static_cast<unsigned>(scenes.size()));
    const Scene scene = scene_of(boxes.width, boxes.height, boxes.xyz);
    for (const Scene& seen : {scene, tilted_plane()}) {
      scenes.push_back(stored(moved(seen, camera_on_a_robot()), order));
    }
  }
  return scenes;
}

}  // namespace cleave::segmentation
