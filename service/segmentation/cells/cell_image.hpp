// SPDX-License-Identifier: BSD-3-Clause
// An organised cloud in cells, super-pixels on a regular grid: square blocks of a few pixels, a
// point each. What the fast path has instead of voxels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "segmentation/cloud_view.hpp"
#include "segmentation/points/pixel_image.hpp"
#include "segmentation/view/camera/pixel_pitch.hpp"

namespace cleave::segmentation {

// Structure of arrays over cells, row-major, inside a border of empty cells: a neighbour is a fixed
// offset away, and no loop asks whether it is there. A cell without points lies nowhere near
// another: its coordinates are `nowhere`, its inverse depth is -nowhere.
struct CellImage {
  static constexpr std::uint32_t border = 20;  // cells on every side
  static constexpr float nowhere = 1e9F;
  static constexpr std::uint32_t no_cell = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t edge = 1;                           // of a cell, pixels
  std::uint32_t shift_x = 0, shift_y = 0;           // pixels that the first column and row lack
  std::uint32_t columns = 0, rows = 0;              // without the border
  std::uint32_t stride = 0;                         // cells from one row to the next
  float pitch = 0;                                  // of a cell, in units of x/z
  std::vector<float> x, y, z;                       // mean of the cell's points, metres
  std::vector<float> u, v, inverse_depth;           // x/z, y/z, 1/z of that
  std::vector<float> normal_x, normal_y, normal_z;  // unit length, towards the sensor
  std::vector<float> points;                        // how many points the mean is of

  // Offsets to the neighbours east, south-west, south, south-east; minus them, the other four.
  [[nodiscard]] std::array<std::ptrdiff_t, 4> steps() const {
    const auto down = static_cast<std::ptrdiff_t>(stride);
    return {1, down - 1, down, down + 1};
  }
  [[nodiscard]] std::size_t size() const { return points.size(); }
  [[nodiscard]] std::size_t row_begin(std::uint32_t row) const {
    return std::size_t{row + border} * stride + border;
  }
  [[nodiscard]] bool occupied(std::size_t cell) const { return points[cell] > 0; }
};

// Gathers an organised cloud into planes of pixels, and these into cells. Where depths in a cell
// differ by more than 1.5 percent, only its front layer counts: a mean over two surfaces lies on
// neither.
class CellImager {
 public:
  // `size`: edge of a cell in units of x/z, rounded to whole pixels. `grid_offset`: 0 to 1, which
  // of the grid's edge * edge positions in the image. Leaves `pixels.segment` alone. False, with
  // `cells` and `pixels` undefined, if the cloud is not an image seen from the origin: no two
  // pixels side by side, or, but for a few stray points (max_strays), points with z <= 0, x/z that
  // does not grow along rows or y/z that does not along columns.
  [[nodiscard]] bool gather(const CloudView& cloud, float size, float grid_offset, CellImage& cells,
                            PixelImage& pixels);

 private:
  void lay_out(const CloudView& cloud, float grid_offset, CellImage& cells, PixelImage& pixels);
  void sum_front_layer(const PixelImage& pixels, std::uint32_t first_row, std::uint32_t rows,
                       const CellImage& cells);
  void store_row(std::uint32_t row, CellImage& cells) const;

  PixelPitchFinder pitch_finder_;
  std::vector<float> limit_m_, sum_x_, sum_y_, sum_z_,
      count_;  // a column of pixels in a row of cells
};

}  // namespace cleave::segmentation
