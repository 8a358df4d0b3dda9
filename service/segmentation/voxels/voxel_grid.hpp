// SPDX-License-Identifier: BSD-3-Clause
// Downsampling to voxels (section 2.1.2.1).
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "segmentation/math/cell_packing.hpp"
#include "segmentation/math/cell_ranking.hpp"
#include "segmentation/math/moments.hpp"
#include "segmentation/options.hpp"
#include "segmentation/points/point_set.hpp"

namespace cleave::segmentation {

struct VoxelGrid {
  CellPacking packing;
  std::vector<std::uint64_t> key;         // a voxel, ascending
  std::vector<Moments> moments;           // of a voxel's points
  std::vector<Eigen::Vector3f> centroid;  // of a voxel's points, metres
  // Points that follow each other in the cloud often share a voxel: those are one run.
  std::vector<std::uint32_t> run_begin;  // runs + 1; indices of points
  std::vector<std::uint32_t> run_voxel;  // runs
  bool one_viewpoint = true;             // or several

  [[nodiscard]] std::size_t size() const { return key.size(); }
  [[nodiscard]] std::size_t runs() const { return run_voxel.size(); }
};

// Sorts points into voxels: cubes in (x/z, y/z, ln z), or for Viewpoint::multiple in (x, y, z).
class Voxeliser {
 public:
  void voxelise(const PointSet& points, const VoxelOptions& options, VoxelGrid& grid);

 private:
  void find_cells(const PointSet& points, const VoxelOptions& options, bool one_viewpoint);
  void find_runs(VoxelGrid& grid);

  std::array<std::vector<std::int32_t>, 3> cell_;  // a point; after find_runs, a run
  std::vector<std::uint64_t> run_key_;
  CellRanking ranking_;
};

}  // namespace cleave::segmentation
