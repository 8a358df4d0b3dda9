// SPDX-License-Identifier: BSD-3-Clause
// Which neighbouring cells lie on one surface.
#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/cells/cell_image.hpp"

namespace cleave::segmentation {

// Two neighbours are linked if their depths differ by less than 1 percent; or, where a surface is
// seen at a grazing angle, by less than 4 percent if each lies on the plane of the other.
//
// Links of a cell to the neighbours at CellImage::steps(): bit k is set if step k leads to a cell
// of the same surface. The links against those steps are bits of the neighbours.
using CellLinks = std::vector<std::uint8_t>;

void link_cells(const CellImage& cells, CellLinks& links);

}  // namespace cleave::segmentation
