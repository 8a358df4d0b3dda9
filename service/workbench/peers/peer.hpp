// SPDX-License-Identifier: BSD-3-Clause
// What the segmentation is measured beside: other methods, in one form.
#pragma once

#include <cstdint>
#include <span>

#include "segmentation/cloud_view.hpp"

namespace cleave::peers {

// One thread; one cloud after the other. PCL goes through sets of pointers in places: its labels
// may differ a little from run to run.
class Peer {
 public:
  virtual ~Peer() = default;

  // Takes the cloud over into the form that the method works on, which is no part of its cost.
  virtual void prepare(const segmentation::CloudView& cloud) = 0;
  // Segments the prepared cloud, and leaves a label for each of its points: 0 = the method leaves
  // the point without one, or it is not finite.
  virtual void segment(std::span<std::uint16_t> labels) = 0;
};

// PCL's SupervoxelClustering as the methods below use it: Papon et al., "Voxel Cloud Connectivity
// Segmentation", CVPR 2013. The values are those of the thesis and of LCCP's paper.
struct SupervoxelParameters {
  float voxel_m = 0.0075F;
  float seed_m = 0.03F;
  float spatial_weight = 1;
  float normal_weight = 4;
  // Voxels that grow with depth, PCL's default for organised clouds.
  bool single_camera_transform = true;
};

// PCL's LCCPSegmentation: Stein et al., "Object Partitioning using Local Convexity", CVPR 2014,
// with the values of that paper.
struct LccpParameters {
  SupervoxelParameters supervoxels;
  float concavity_tolerance_deg = 10;
  bool sanity_check = true;
  std::uint32_t k_factor = 1;  // extended convexity
  std::uint32_t min_segment_supervoxels = 3;
};
// PCL's CPCSegmentation on top of that: Schoeler et al., "Constrained Planar Cuts - Object
// Partitioning for Point Clouds", CVPR 2015, with the values of PCL's example.
struct CpcParameters {
  LccpParameters lccp;
  std::uint32_t max_cuts = 25;
  std::uint32_t cutting_min_segments = 400;
  float min_cut_score = 0.16F;
  std::uint32_t ransac_iterations = 10000;
};
// The best that was found for LCCP on table-top scenes.
[[nodiscard]] LccpParameters tuned_lccp();

}  // namespace cleave::peers
