#include "segmentation/supervoxel_partition.hpp"

namespace cleave::segmentation {

std::uint32_t SupervoxelPartitioner::partition(const ForeignSupervoxels& supervoxels,
                                               const Options& options,
                                               std::vector<std::uint32_t>& segment) {
  build_supervoxel_graph(supervoxels.adjacent_pairs, supervoxels.surfel, options.graph, edges_);
  const auto count = static_cast<std::uint32_t>(supervoxels.surfel.size());
  const std::uint32_t segments = partitioner_.partition(count, edges_, options, segment);
  if (options.clean_up.join_across_borders) {
    joiner_.join(edges_, supervoxels.surfel, options.graph, segments, segment);
  }
  merger_.merge(edges_, supervoxels.point_count, segments, options.clean_up, segment);
  return segments;
}

}  // namespace cleave::segmentation
