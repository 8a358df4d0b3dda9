// SPDX-License-Identifier: BSD-3-Clause
// The way of a frame from points to a graph of supervoxels, and from segments back to its points.
// What the method does in between knows supervoxels alone.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "segmentation/describe/surface.hpp"
#include "segmentation/graph/supervoxel_graph.hpp"
#include "segmentation/graph/supervoxels.hpp"
#include "segmentation/options.hpp"
#include "segmentation/points/point_runs.hpp"
#include "segmentation/spacing/cloud_spacing.hpp"

namespace cleave::segmentation {

// Has gathered the points of a cloud; each step needs those before it, in this order. Another
// representation of a cloud is one more of these, in a folder of its own, and a line in PathFinder.
class SupervoxelPath {
 public:
  SupervoxelPath() = default;
  virtual ~SupervoxelPath() = default;
  SupervoxelPath(const SupervoxelPath&) = delete;
  SupervoxelPath& operator=(const SupervoxelPath&) = delete;

  // How far apart the points are: what options are scaled by.
  [[nodiscard]] virtual CloudSpacing spacing() const = 0;
  // Whether depth means distance from a sensor, for all points alike.
  [[nodiscard]] virtual bool seen_from_one_viewpoint() const = 0;

  virtual void estimate_normals() = 0;
  virtual void cluster(const SupervoxelOptions& options, Supervoxels& supervoxels) = 0;
  virtual void build_graph(const Supervoxels& supervoxels, const Options& options,
                           std::vector<SupervoxelEdge>& edges) = 0;
  // A segment to each point.
  virtual void label_points(const Supervoxels& supervoxels,
                            const std::vector<std::uint32_t>& segment_of_supervoxel,
                            const RefineOptions& options) = 0;

  [[nodiscard]] virtual SegmentedPoints points() const = 0;
  // Labels by the cloud's points; those of points that were not measured are left alone.
  virtual void write_labels(const std::vector<std::uint16_t>& label_of_segment,
                            std::span<std::uint16_t> labels) const = 0;
  // Small patches that stand for the points of all segments.
  virtual void list_surface(const std::vector<std::uint32_t>& segment_of_supervoxel,
                            Surface& surface) const = 0;
};

}  // namespace cleave::segmentation
