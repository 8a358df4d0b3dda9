// One scene in other storage orders and frames, and how alike its segmentations are.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "segmentation/segmenter.hpp"
#include "segmentation/view/storage_order.hpp"

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

struct SegmentedScene {
  std::vector<std::uint16_t> labels;
  Segmentation segmentation;
};

[[nodiscard]] inline SegmentedScene segmented(const CloudView& cloud, const Options& options = {}) {
  SegmentedScene result;
  result.labels.resize(cloud.size());
  (void)Segmenter(options).segment(cloud, result.labels, result.segmentation);
  return result;
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

}  // namespace cleave::segmentation
