// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/view/storage_order.hpp"

#include <utility>

namespace cleave::segmentation {

UprightImage::UprightImage(StorageOrder order, std::uint32_t width, std::uint32_t height)
    : order_(order), width_(width), height_(height) {
  const std::ptrdiff_t row = width;
  if (order.columns_reversed) first_ += row - 1;
  if (order.rows_reversed) first_ += row * (std::ptrdiff_t{height} - 1);
  column_step_ = order.columns_reversed ? -1 : 1;
  row_step_ = order.rows_reversed ? -row : row;
  if (order.transposed) std::swap(column_step_, row_step_);
}

ImageRectangle UprightImage::stored(const ImageRectangle& upright) const {
  ImageRectangle r = upright;
  if (order_.transposed) r = {r.top, r.left, r.bottom, r.right};
  if (order_.columns_reversed) {
    r.left = width_ - std::exchange(r.right, width_ - r.left);
  }
  if (order_.rows_reversed) {
    r.top = height_ - std::exchange(r.bottom, height_ - r.top);
  }
  return r;
}

}  // namespace cleave::segmentation
