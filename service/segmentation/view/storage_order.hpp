// SPDX-License-Identifier: BSD-3-Clause
// The eight orders in which the pixels of one image can be stored.
#pragma once

#include <cstddef>
#include <cstdint>

#include "segmentation/segmentation.hpp"

namespace cleave::segmentation {

// How an image is stored whose upright columns go right and whose rows go down. Default: so.
struct StorageOrder {
  bool transposed = false;                               // upright columns are stored as rows
  bool columns_reversed = false, rows_reversed = false;  // of those stored

  [[nodiscard]] bool upright() const { return !transposed && !columns_reversed && !rows_reversed; }
};

// An image of `width` x `height` stored pixels, seen upright.
class UprightImage {
 public:
  UprightImage(StorageOrder order, std::uint32_t width, std::uint32_t height);

  [[nodiscard]] std::uint32_t width() const { return order_.transposed ? height_ : width_; }
  [[nodiscard]] std::uint32_t height() const { return order_.transposed ? width_ : height_; }
  // Where the pixel in an upright column and row is stored.
  [[nodiscard]] std::size_t index(std::uint32_t column, std::uint32_t row) const {
    return static_cast<std::size_t>(first_ + column_step_ * std::ptrdiff_t{column} +
                                    row_step_ * std::ptrdiff_t{row});
  }
  // The stored columns and rows of an upright rectangle.
  [[nodiscard]] ImageRectangle stored(const ImageRectangle& upright) const;

 private:
  StorageOrder order_;
  std::uint32_t width_, height_;
  std::ptrdiff_t first_ = 0, column_step_ = 1, row_step_ = 1;
};

}  // namespace cleave::segmentation
