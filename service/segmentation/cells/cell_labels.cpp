// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/cells/cell_labels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "segmentation/cells/cell_clustering.hpp"
#include "segmentation/math/multiversion.hpp"

namespace cleave::segmentation {
namespace {

// The pixel rows or columns of the image that a row or column of cells covers.
struct PixelRange {
  std::uint32_t begin, end;
};
PixelRange pixels_of(std::uint32_t cell, std::uint32_t edge, std::uint32_t shift,
                     std::uint32_t size) {
  const std::uint32_t begin = cell * edge;
  return {begin > shift ? begin - shift : 0, std::min(begin + edge - shift, size)};
}

// Marks the cells of a row, empty ones left out, whose neighbour one `way` is in another segment.
CLEAVE_MULTIVERSION
void mark_borders(const std::uint32_t* segment, std::ptrdiff_t way, std::size_t count,
                  std::uint32_t* __restrict marks) {
  constexpr std::uint32_t none = PixelImage::no_segment;
  const std::uint32_t* other = segment + way;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t both = (segment[i] != none ? 1U : 0U) & (other[i] != none ? 1U : 0U);
    marks[i] |= both & (other[i] != segment[i] ? 1U : 0U);
  }
}

CLEAVE_MULTIVERSION
void fill_measured(const std::uint32_t* __restrict from, const float* __restrict z,
                   std::size_t count, std::uint32_t* __restrict segment) {
  for (std::size_t i = 0; i < count; ++i) {
    segment[i] = z[i] < PixelImage::no_depth ? from[i] : PixelImage::no_segment;
  }
}

}  // namespace

void CellLabeller::fill_rows(const CellImage& cells, std::uint32_t row, PixelImage& image) {
  const std::uint32_t* segment = segment_of_cell_.data() + cells.row_begin(row);
  row_.resize(std::size_t{cells.columns} * cells.edge);
  for (std::uint32_t column = 0; column < cells.columns; ++column) {
    std::fill_n(row_.data() + std::size_t{column} * cells.edge, cells.edge, segment[column]);
  }
  const PixelRange rows = pixels_of(row, cells.edge, cells.shift_y, image.layout.height);
  for (std::uint32_t y = rows.begin; y < rows.end; ++y) {
    const std::size_t begin = image.layout.row_begin(y);
    fill_measured(row_.data() + cells.shift_x, image.z.data() + begin, image.layout.width,
                  image.segment.data() + begin);
  }
}

void CellLabeller::find_borders(const CellImage& cells, std::uint32_t row) {
  borders_.assign(cells.columns, 0);
  for (const std::ptrdiff_t step : cells.steps()) {
    for (const std::ptrdiff_t way : {step, -step}) {
      mark_borders(segment_of_cell_.data() + cells.row_begin(row), way, cells.columns,
                   borders_.data());
    }
  }
}

CellLabeller::Candidates CellLabeller::candidates_around(
    const CellImage& cells, std::size_t cell,
    const std::vector<std::uint32_t>& supervoxel_of_cell) const {
  Candidates found;
  found.supervoxel[found.count++] = supervoxel_of_cell[cell];
  for (const std::ptrdiff_t step : cells.steps()) {
    for (const std::size_t other :
         {cell + static_cast<std::size_t>(step), cell - static_cast<std::size_t>(step)}) {
      const std::uint32_t s = supervoxel_of_cell[other];
      const auto end = found.supervoxel.begin() + found.count;
      if (s == CellClusterer::no_owner || std::find(found.supervoxel.begin(), end, s) != end) {
        continue;
      }
      found.supervoxel[found.count++] = s;
    }
  }
  return found;
}

std::uint32_t CellLabeller::nearest_plane(const Eigen::Vector3f& point,
                                          const Candidates& candidates) const {
  std::uint32_t nearest = candidates.supervoxel[0];
  float least_distance_m = std::numeric_limits<float>::infinity();
  for (std::size_t k = 0; k < candidates.count; ++k) {
    const Plane& plane = plane_[candidates.supervoxel[k]];
    const float distance_m = std::abs(plane.normal.dot(point) - plane.offset_m);
    if (distance_m < least_distance_m) {
      least_distance_m = distance_m;
      nearest = candidates.supervoxel[k];
    }
  }
  return nearest;
}

void CellLabeller::refine_row(const CellImage& cells, std::uint32_t row,
                              const std::vector<std::uint32_t>& supervoxel_of_cell,
                              const std::vector<std::uint32_t>& segment_of_supervoxel,
                              PixelImage& image) {
  const PixelRange rows = pixels_of(row, cells.edge, cells.shift_y, image.layout.height);
  find_borders(cells, row);
  for (std::uint32_t column = 0; column < cells.columns; ++column) {
    const std::size_t cell = cells.row_begin(row) + column;
    if (borders_[column] == 0) continue;
    const std::uint32_t own = segment_of_cell_[cell];
    bool is_mixed = false;
    const Candidates candidates = candidates_around(cells, cell, supervoxel_of_cell);
    const PixelRange columns = pixels_of(column, cells.edge, cells.shift_x, image.layout.width);
    for (std::uint32_t y = rows.begin; y < rows.end; ++y) {
      const std::size_t begin = image.layout.row_begin(y);
      for (std::size_t i = begin + columns.begin; i < begin + columns.end; ++i) {
        if (image.segment[i] == PixelImage::no_segment) continue;
        const Eigen::Vector3f point(image.x[i], image.y[i], image.z[i]);
        image.segment[i] = segment_of_supervoxel[nearest_plane(point, candidates)];
        is_mixed |= image.segment[i] != own;
      }
    }
    if (is_mixed) mixed_.push_back(static_cast<std::uint32_t>(cell));
  }
}

void CellLabeller::label(const CellImage& cells,
                         const std::vector<std::uint32_t>& supervoxel_of_cell,
                         const Supervoxels& supervoxels,
                         const std::vector<std::uint32_t>& segment_of_supervoxel, bool refine,
                         PixelImage& image) {
  plane_.resize(supervoxels.size());
  for (std::size_t s = 0; s < supervoxels.size(); ++s) {
    const Surfel& surfel = supervoxels.surfel[s];
    plane_[s] = {surfel.normal, surfel.normal.dot(surfel.position)};
  }
  segment_of_cell_.resize(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::uint32_t s = supervoxel_of_cell[i];
    segment_of_cell_[i] =
        s == CellClusterer::no_owner ? PixelImage::no_segment : segment_of_supervoxel[s];
  }
  mixed_.clear();
  for (std::uint32_t row = 0; row < cells.rows; ++row) {
    fill_rows(cells, row, image);
    if (refine) refine_row(cells, row, supervoxel_of_cell, segment_of_supervoxel, image);
  }
}

void CellLabeller::find_mixed_windows(const CellImage& cells, std::uint32_t radius,
                                      const PixelImage& image, std::vector<PixelSpan>& spans) {
  auto& marks = mixed_window_finder_.clear_marks(cells.size());
  for (const std::uint32_t cell : mixed_) marks[cell] = 1;
  const TileGrid grid{.edge = cells.edge,
                      .shift_x = cells.shift_x,
                      .shift_y = cells.shift_y,
                      .columns = cells.columns,
                      .rows = cells.rows,
                      .stride = cells.stride,
                      .first = cells.row_begin(0)};
  mixed_window_finder_.find(grid, segment_of_cell_, radius, image.layout, spans);
}

}  // namespace cleave::segmentation
