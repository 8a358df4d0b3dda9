// SPDX-License-Identifier: BSD-3-Clause
// All that can be chosen, one struct a step. The defaults are ours; thesis() names the thesis's.
#pragma once

#include <cstdint>

namespace cleave::segmentation {

enum class Algorithm { ssc, constrained_ssc, svc, convex_components };

// Where the cloud was seen from. `automatic`: an image from its camera; an unorganised cloud from
// the pose it came with, or the origin, if its points are more even as seen from there than in
// metres (view/point_view).
enum class Viewpoint { automatic, single, multiple };

// What a cloud is made smaller with. Cells are super-pixels on a regular grid, blocks of a few
// pixels: they take a fifth of the time and need an image seen from one viewpoint, in any frame and
// storage order (view/image_view). Any other cloud is made into voxels.
enum class Representation { cells, voxels };

// Which Laplacian the eigenvectors are of: equation 2.11, 2.13 or 2.14.
enum class Laplacian { unnormalised, symmetric, random_walk };

// Whether the parts that a graph was cut into are decomposed anew (Algorithm 1), or all cuts come
// from the eigenvectors of the whole (section 5.3.2).
enum class Decomposition { recursive, single };

// Which voxels are neighbours: those that share a face (6), an edge as well (18), or a corner (26).
// `automatic`: as in the thesis, 18 for svc and 26 for supervoxels.
enum class Neighbourhood { automatic, faces, edges, corners };

struct VoxelOptions {
  // Edge of a voxel. With one viewpoint it is measured in (x/z, y/z, ln z), so that voxels grow
  // with the distance as the sampling does (section 2.1.2.1); with several, in metres.
  float size_m = 0.006F;
  // Where points are too far apart for voxels of the default size to hold together, voxels grow
  // until they do (VoxelFitter), and the defaults of later steps follow (options_for_spacing). What
  // is set to another value than its default is kept.
  bool follow_spacing = true;
  Viewpoint viewpoint = Viewpoint::automatic;
  // Of voxels: cells have their own neighbours, and it is refused where images become cells.
  Neighbourhood neighbourhood = Neighbourhood::automatic;
  // Shift of the grid in voxels, 0 to 1, for judging a change by its mean over several grids.
  float grid_offset = 0;
};

struct SupervoxelOptions {
  float seed_spacing_m = 0.025F;
  float spatial_weight = 1;
  float normal_weight = 8;
  std::uint32_t min_seed_voxels = 5;  // cells of the seed grid with fewer voxels get no seed
  std::uint32_t sweeps = 0;           // of k-means; 0: six of voxels, three of cells
  bool refit_from_points = true;      // each voxel or cell counts by its points, not as one
};

// How convex edges are told (section 4.1.2.2): after Karpathy et al., equation 4.1, or after Lai et
// al., 4.2; and how concave ones are weighed (4.3).
enum class Convexity { karpathy, lai };
enum class WeightFunction { inverse_quadratic, gaussian };

struct GraphOptions {
  Convexity convexity = Convexity::karpathy;
  WeightFunction weight = WeightFunction::inverse_quadratic;
  // eq. 4.3: of the inverse quadratic a factor, of the Gaussian a divisor (0.1 is a good one).
  float weight_sigma = 80;
  float validity_max_rad = 0.9F;        // eq. 4.5: 52 deg
  float validity_offset_rad = 0.6632F;  // eq. 4.5: 38 deg
  float validity_slope = 17.19F;        // eq. 4.5: 0.3 a degree, here a radian
  float cannot_link_rad = 0.6981F;      // eq. 4.7: 40 deg
  // Soft constraints: from this concave angle to cannot_link_rad an edge is cannot-link in part,
  // linearly from nothing to whole. The same or more: eq. 4.7 alone.
  float soft_cannot_link_rad = 0.35F;
  // Edges between patches that lie almost parallel are invalid if one is off the other's plane by
  // more than this at 1 m, growing with the distance squared as the sensor's noise does; 0: never.
  float max_step_m = 0.0045F;
};

struct PartitionOptions {
  std::uint32_t eigenvectors = 8;  // k of Algorithm 1, the constant one not counted
  float utility_threshold = 0.5F;  // Algorithm 1, line 13
  Decomposition decomposition = Decomposition::recursive;
  Laplacian laplacian = Laplacian::unnormalised;
  // Constrained SSC, which takes one eigenvector: what a cannot-link edge weighs less than nothing
  // in the Laplacian, -omega_CL of section 4.1.4. 0: the ratio cut of plain SSC.
  float cannot_link_weight = 1;
  // Each joins up to half of the supervoxels with a neighbour on the same smooth surface before
  // the graph is cut.
  std::uint32_t coarsening_rounds = 4;
};

// Spectral Voxel Clustering (section 4.2). The thesis gives no numbers; these are measured.
struct SvcOptions {
  float normal_sigma = 200;        // eq. 4.16, phi_n
  float curvature_sigma = 1e5F;    // eq. 4.16, phi_c
  float utility_threshold = 0.7F;  // of eq. 4.19, eigenvectors scaled to lie between 0 and 1
  std::uint32_t min_voxels = 30;   // a cut leaves at least as many on both sides
};

struct ConvexComponentsOptions {
  float tolerance_rad = 0.3491F;  // concave edges that bend by no more connect: 20 deg
};

struct CleanUpOptions {
  // Neighbours whose common border gives no reason to part them join: see BorderJoiner.
  bool join_across_borders = true;
  // Smaller segments join a neighbour; those without one are no segments, but label 0; 0 = off.
  // The default follows sparse clouds: see options_for_spacing().
  std::uint32_t min_segment_points = 145;
  // Smaller segments, and pairs of which both have fewer than four times as many points, join
  // across a weak border: one that is cannot-link along little of its length; 0 = off.
  std::uint32_t weak_border_points = 500;
};

struct RefineOptions {
  bool boundary = true;                  // points of border voxels go to the nearest plane
  std::uint32_t mode_filter_radius = 4;  // pixels, organised clouds only; 0 = off
  float mode_filter_depth_gate_m = 0.02F;
};

struct DescribeOptions {
  float plane_distance_m = 0.01F;
};

// An algorithm reads some of them: what it would ignore is refused where it is set to a value that
// its preset does not give it (ignored_options).
struct Options {
  Algorithm algorithm = Algorithm::ssc;
  Representation representation = Representation::cells;
  VoxelOptions voxel;
  SupervoxelOptions supervoxel;
  GraphOptions graph;
  PartitionOptions partition;
  SvcOptions svc;
  ConvexComponentsOptions convex_components;
  CleanUpOptions clean_up;
  RefineOptions refine;
  DescribeOptions describe;
};

// The plain method of the thesis: 7.5 mm voxels, 30 mm seeds, no clean-up, no refinement.
[[nodiscard]] Options thesis();

}  // namespace cleave::segmentation
