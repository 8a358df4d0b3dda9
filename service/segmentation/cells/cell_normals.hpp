// SPDX-License-Identifier: BSD-3-Clause
// Normals of cells, by regression in the space in which the sensor measures.
#pragma once

#include <vector>

#include "segmentation/cells/cell_image.hpp"

namespace cleave::segmentation {

// With u = x/z and v = y/z, a plane is 1/z = a u + b v + c: linear, with the sensor's noise in 1/z
// alone. So a weighted least-squares fit, two equations in a and b, stands for the eigenproblem of
// PCA (section 2.1.2.2).
class CellNormalEstimator {
 public:
  // Fills the normals of `cells`. First a plane is fitted to the 5x5 cells around each: near ones
  // count more, and those count that are on the same surface, where 1/z differs by less than 1.2
  // percent a cell of distance. Then each cell takes, of its own plane and its eight neighbours',
  // the one that fits its cells best and passes nearest: beside a crease that is a plane from one
  // side of it, not a mean of both (Kuwahara et al., 1976). Where cells lie on a line and no
  // neighbour has a plane, the normal is the direction to the sensor; of empty cells it means
  // nothing.
  void estimate(CellImage& cells);

 private:
  std::vector<float> a_, b_, c_;  // of a cell's plane
  std::vector<float> variance_;   // of 1/z about it
};

}  // namespace cleave::segmentation
