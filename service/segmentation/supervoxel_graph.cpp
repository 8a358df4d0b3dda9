#include "segmentation/supervoxel_graph.hpp"

#include "segmentation/edge_heuristics.hpp"

namespace cleave::segmentation {

void build_supervoxel_graph(const std::vector<AdjacentPair>& pairs,
                            const std::vector<Surfel>& supervoxels, const GraphOptions& options,
                            std::vector<SupervoxelEdge>& edges) {
  const float least_weight = cannot_link_weight(options);
  edges.clear();
  for (const AdjacentPair& pair : pairs) {
    const Surfel& i = supervoxels[pair.first];
    const Surfel& j = supervoxels[pair.second];
    const float weight = edge_weight(i, j, options);
    edges.push_back({.first = pair.first,
                     .second = pair.second,
                     .touching_voxels = pair.touching_voxels,
                     .weight = weight,
                     .cosine = i.normal.dot(j.normal),
                     .convex = is_convex(i, j, options.convexity),
                     .valid = is_valid(i, j, options),
                     .cannot_link = weight < least_weight});
  }
}

}  // namespace cleave::segmentation
