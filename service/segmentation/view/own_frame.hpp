// SPDX-License-Identifier: BSD-3-Clause
// Is the cloud in its sensor's coordinate frame: an image seen from its own origin along its own z
// axis? Then nothing has to move.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "segmentation/view/camera/pixel_sample.hpp"
#include "segmentation/view/storage_order.hpp"

namespace cleave::segmentation {

struct OwnFrame {
  StorageOrder order;
  bool exact = false;  // nearly all pixels look where a pinhole camera's do
};

class OwnFrameFinder {
 public:
  // Fits x/z and y/z, linear in column and row. Nothing where points are not in front, or the
  // image's axes lie across x and y.
  [[nodiscard]] std::optional<OwnFrame> find(const std::vector<SampledPixel>& pixels);

 private:
  struct Pixel {
    Eigen::Vector2d at;     // column, row
    Eigen::Vector2d sight;  // x/z, y/z
  };
  [[nodiscard]] bool fit();  // false where pixels lie on a line
  [[nodiscard]] double squared_miss_px(const Pixel& pixel) const;
  [[nodiscard]] double share_hit() const;
  void drop_strays();

  std::vector<Pixel> all_, kept_;
  std::vector<double> misses_;
  Eigen::Vector2d mean_at_, mean_sight_;
  Eigen::Matrix2d pitch_;  // of sight, by column and by row
};

}  // namespace cleave::segmentation
