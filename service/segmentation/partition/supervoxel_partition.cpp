// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/partition/supervoxel_partition.hpp"

namespace cleave::segmentation {

std::uint32_t SupervoxelPartitioner::partition(const ForeignSupervoxels& supervoxels,
                                               const Options& options,
                                               std::vector<std::uint32_t>& segment) {
  build_supervoxel_graph(supervoxels.adjacent_pairs, supervoxels.surfel, options.graph, edges_);
  const auto count = static_cast<std::uint32_t>(supervoxels.surfel.size());
  const std::uint32_t segments = partitioner_.partition(count, edges_, options, segment);
  cleaner_.clean(edges_, supervoxels.surfel, supervoxels.point_count, segments, options, segment);
  return segments;
}

}  // namespace cleave::segmentation
