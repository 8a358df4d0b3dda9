// SPDX-License-Identifier: BSD-3-Clause
// From segments of supervoxels to segments of pixels, with borders finer than a cell.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "segmentation/cells/cell_image.hpp"
#include "segmentation/graph/supervoxels.hpp"
#include "segmentation/points/mixed_windows.hpp"
#include "segmentation/points/pixel_image.hpp"

namespace cleave::segmentation {

class CellLabeller {
 public:
  // Fills image.segment: each measured pixel takes the segment of its cell's supervoxel. With
  // `refine`, a pixel of a cell that has a neighbour in another segment goes to the supervoxel, of
  // those in the 3x3 cells around, whose plane is nearest.
  void label(const CellImage& cells, const std::vector<std::uint32_t>& supervoxel_of_cell,
             const Supervoxels& supervoxels,
             const std::vector<std::uint32_t>& segment_of_supervoxel, bool refine,
             PixelImage& image);

  // Of the last image, for the mode filter.
  void find_mixed_windows(const CellImage& cells, std::uint32_t radius, const PixelImage& image,
                          std::vector<PixelSpan>& spans);

 private:
  struct Plane {
    Eigen::Vector3f normal;
    float offset_m;  // normal . any point of the plane
  };
  struct Candidates {
    std::array<std::uint32_t, 9> supervoxel;
    std::size_t count = 0;
  };
  void fill_rows(const CellImage& cells, std::uint32_t row, PixelImage& image);
  void refine_row(const CellImage& cells, std::uint32_t row,
                  const std::vector<std::uint32_t>& supervoxel_of_cell,
                  const std::vector<std::uint32_t>& segment_of_supervoxel, PixelImage& image);
  void find_borders(const CellImage& cells, std::uint32_t row);
  [[nodiscard]] Candidates candidates_around(
      const CellImage& cells, std::size_t cell,
      const std::vector<std::uint32_t>& supervoxel_of_cell) const;
  [[nodiscard]] std::uint32_t nearest_plane(const Eigen::Vector3f& point,
                                            const Candidates& candidates) const;

  std::vector<Plane> plane_;                    // of a supervoxel
  std::vector<std::uint32_t> segment_of_cell_;  // no_segment for empty cells
  std::vector<std::uint32_t> row_;              // of pixels, whole cells
  std::vector<std::uint32_t> borders_;          // of a row: 1 for cells beside another segment
  std::vector<std::uint32_t> mixed_;            // cells with pixels of other segments
  MixedWindowFinder mixed_window_finder_;
};

}  // namespace cleave::segmentation
