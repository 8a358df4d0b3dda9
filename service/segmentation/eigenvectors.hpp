// The spectral relaxation: small eigenvectors of a graph's Laplacian (sections 2.2.2.1, 4.1.3.2).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace cleave::segmentation {

struct WeightedEdge {
  std::uint32_t first = 0, second = 0;
  double weight = 0;
};

// Unit eigenvectors, as columns, of the `wanted` smallest eigenvalues of L = D - A (equation 2.11)
// after the trivial one, ascending; fewer where the graph has no more. For a connected graph of two
// vertices or more without parallel edges. The same graph gives the same bits.
[[nodiscard]] Eigen::MatrixXd laplacian_eigenvectors(std::size_t vertices,
                                                     const std::vector<WeightedEdge>& edges,
                                                     std::uint32_t wanted);

}  // namespace cleave::segmentation
