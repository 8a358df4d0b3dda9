// SPDX-License-Identifier: BSD-3-Clause
// Points that follow each other and lie in one segment.
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/points/pixel_image.hpp"
#include "segmentation/points/point_set.hpp"

namespace cleave::segmentation {

struct PointRun {
  std::uint32_t segment = 0;
  std::uint32_t begin = 0, end = 0;            // indices of x, y, z
  std::uint32_t row = 0, left = 0, right = 0;  // of the image; half-open columns
};

// Points and the segments that they lie in, in the cloud's order. Looks at others' memory.
struct SegmentedPoints {
  const float *x = nullptr, *y = nullptr, *z = nullptr;  // metres
  const std::vector<PointRun>* runs = nullptr;
};

// Every run lies in one image row. `width`: of the cloud. Columns between a run's points may have
// no measurement.
void list_runs(const PointSet& points, const std::vector<std::uint32_t>& segment_of_point,
               std::uint32_t width, std::vector<PointRun>& runs);

// Pixels of a run are side by side.
void list_runs(const PixelImage& image, std::vector<PointRun>& runs);

}  // namespace cleave::segmentation
