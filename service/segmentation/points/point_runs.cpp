// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/points/point_runs.hpp"

namespace cleave::segmentation {

void list_runs(const PointSet& points, const std::vector<std::uint32_t>& segment_of_point,
               std::uint32_t width, std::vector<PointRun>& runs) {
  runs.clear();
  const auto size = static_cast<std::uint32_t>(points.size());
  std::uint32_t row = 0;
  std::uint32_t row_begin = 0;  // index in the cloud
  for (std::uint32_t i = 0; i < size;) {
    while (points.index[i] - row_begin >= width) {
      row_begin += width;
      ++row;
    }
    const std::uint32_t begin = i;
    const std::uint32_t segment = segment_of_point[i];
    while (i < size && segment_of_point[i] == segment && points.index[i] - row_begin < width) ++i;
    runs.push_back({.segment = segment,
                    .begin = begin,
                    .end = i,
                    .row = row,
                    .left = points.index[begin] - row_begin,
                    .right = points.index[i - 1] - row_begin + 1});
  }
}

void list_runs(const PixelImage& image, std::vector<PointRun>& runs) {
  runs.clear();
  for (std::uint32_t row = 0; row < image.layout.height; ++row) {
    const auto row_begin = static_cast<std::uint32_t>(image.layout.row_begin(row));
    const std::uint32_t* segment = image.segment.data() + row_begin;
    for (std::uint32_t column = 0; column < image.layout.width;) {
      const std::uint32_t left = column;
      // The border behind the last column has no segment.
      while (segment[column] == segment[left] && column < image.layout.width) ++column;
      if (segment[left] == PixelImage::no_segment) continue;
      runs.push_back({.segment = segment[left],
                      .begin = row_begin + left,
                      .end = row_begin + column,
                      .row = row,
                      .left = left,
                      .right = column});
    }
  }
}

}  // namespace cleave::segmentation
