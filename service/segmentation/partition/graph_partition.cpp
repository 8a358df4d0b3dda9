// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/partition/graph_partition.hpp"

namespace cleave::segmentation {

std::uint32_t GraphPartitioner::partition(std::uint32_t supervoxels,
                                          const std::vector<SupervoxelEdge>& edges,
                                          const Options& options,
                                          std::vector<std::uint32_t>& segment) {
  switch (options.algorithm) {
    case Algorithm::constrained_ssc:
      return partitioner_.partition_constrained(supervoxels, edges, options.partition, segment);
    case Algorithm::svc:
      return voxel_partitioner_.partition(supervoxels, edges, options, segment);
    case Algorithm::convex_components:
      return convex_components_.find(supervoxels, edges, options.convex_components, segment);
    case Algorithm::ssc:
      break;
  }
  return partitioner_.partition(supervoxels, edges, options.partition, segment);
}

}  // namespace cleave::segmentation
