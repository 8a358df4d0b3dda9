// SPDX-License-Identifier: BSD-3-Clause
// Every option by name, with its range and meaning: what files, command lines and the Segmenter's
// own checks are made of, so that none of them lists options itself.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "segmentation/options.hpp"

namespace cleave::segmentation {

// Calls, once an option, in a fixed order and with "step.option" as the name, one of
//   visitor.number(name, float&, double min, double max, meaning)
//   visitor.integer(name, std::uint32_t&, std::uint32_t min, std::uint32_t max, meaning)
//   visitor.boolean(name, bool&, meaning)
//   visitor.choice(name, std::size_t& index, choices, meaning)
// `choices` is a std::array of std::string_view. Both ends of a range are allowed values.
template <typename Visitor>
void visit_options(Options& options, Visitor&& visitor) {
  const auto choice = [&visitor](std::string_view name, auto& value, const auto& choices,
                                 std::string_view meaning) {
    auto index = static_cast<std::size_t>(value);
    visitor.choice(name, index, choices, meaning);
    value = static_cast<std::remove_reference_t<decltype(value)>>(index);
  };
  constexpr double quarter_turn_rad = 1.5708;
  using Names = std::string_view;

  choice(
      "algorithm", options.algorithm,
      std::array{Names("ssc"), Names("constrained-ssc"), Names("svc"), Names("convex-components")},
      "ssc: Spectral Supervoxel Clustering; constrained-ssc: with cannot-link edges in the "
      "eigenproblem; svc: Spectral Voxel Clustering; convex-components: what convex edges connect");

  choice("representation", options.representation, std::array{Names("cells"), Names("voxels")},
         "cells: super-pixels of an image, fast, else voxels; voxels: of any cloud");

  auto& voxel = options.voxel;
  visitor.number("voxel.size_m", voxel.size_m, 0.0005, 1.0, "edge of a voxel, metres at 1 m depth");
  visitor.boolean("voxel.follow_spacing", voxel.follow_spacing,
                  "sizes left at their defaults grow with the spacing of sparse clouds");
  choice(
      "voxel.viewpoint", voxel.viewpoint,
      std::array{Names("automatic"), Names("single"), Names("multiple")},
      "single: voxels grow with depth; multiple: they do not; automatic: as the cloud was sampled");
  choice("voxel.neighbourhood", voxel.neighbourhood,
         std::array{Names("automatic"), Names("6"), Names("18"), Names("26")},
         "neighbours of a voxel, for representation voxels; automatic: 18 for svc, else 26");
  visitor.number("voxel.grid_offset", voxel.grid_offset, 0, 1, "shift of the grid, voxels");

  auto& supervoxel = options.supervoxel;
  visitor.number("supervoxel.seed_spacing_m", supervoxel.seed_spacing_m, 0.002, 10.0,
                 "distance of seeds, metres");
  visitor.number("supervoxel.spatial_weight", supervoxel.spatial_weight, 0, 1000,
                 "weight of the distance in seed spacings");
  visitor.number("supervoxel.normal_weight", supervoxel.normal_weight, 0, 1000,
                 "weight of the difference of normals");
  visitor.integer("supervoxel.min_seed_voxels", supervoxel.min_seed_voxels, 1, 1000,
                  "voxels that a seed's cell must hold");
  visitor.integer("supervoxel.sweeps", supervoxel.sweeps, 0, 100,
                  "k-means sweeps; 0: 6 of voxels, 3 of cells");
  visitor.boolean("supervoxel.refit_from_points", supervoxel.refit_from_points,
                  "fit supervoxels to points, not to voxels or cells");

  auto& graph = options.graph;
  choice("graph.convexity", graph.convexity, std::array{Names("karpathy"), Names("lai")},
         "equation 4.1 or 4.2");
  choice("graph.weight", graph.weight, std::array{Names("inverse-quadratic"), Names("gaussian")},
         "1/(1 + sigma d) or exp(-d/sigma) of equation 4.3");
  visitor.number("graph.weight_sigma", graph.weight_sigma, 0.001, 1e4, "sigma of equation 4.3");
  visitor.number("graph.validity_max_rad", graph.validity_max_rad, 0, quarter_turn_rad,
                 "largest threshold of equation 4.5, radians");
  visitor.number("graph.validity_offset_rad", graph.validity_offset_rad, 0, 2 * quarter_turn_rad,
                 "beta_off of equation 4.5, radians");
  visitor.number("graph.validity_slope", graph.validity_slope, 0, 1e4,
                 "a of equation 4.5, per radian");
  visitor.number("graph.cannot_link_rad", graph.cannot_link_rad, 0, 2 * quarter_turn_rad,
                 "concave angle from which an edge is cannot-link (equation 4.7), radians");
  visitor.number("graph.soft_cannot_link_rad", graph.soft_cannot_link_rad, 0, 2 * quarter_turn_rad,
                 "concave angle from which an edge is cannot-link in part, radians");
  visitor.number("graph.max_step_m", graph.max_step_m, 0, 1,
                 "largest step of one surface at 1 m distance, metres; 0: no limit");

  visitor.integer("partition.eigenvectors", options.partition.eigenvectors, 1, 100,
                  "k of algorithm 1");
  visitor.number("partition.utility_threshold", options.partition.utility_threshold, 0, 1e6,
                 "least utility of a cut (equation 4.8)");
  choice("partition.decomposition", options.partition.decomposition,
         std::array{Names("recursive"), Names("single")},
         "recursive: parts are decomposed anew; single: all cuts from one decomposition");
  choice("partition.laplacian", options.partition.laplacian,
         std::array{Names("unnormalised"), Names("symmetric"), Names("random-walk")},
         "whose eigenvectors: equation 2.11, 2.13 or 2.14");
  visitor.number("partition.cannot_link_weight", options.partition.cannot_link_weight, 0, 1000,
                 "constrained-ssc: -omega_CL, weight of cannot-link edges against linking");
  visitor.integer("partition.coarsening_rounds", options.partition.coarsening_rounds, 0, 20,
                  "rounds of joining smooth neighbours before the graph is cut");

  auto& svc = options.svc;
  visitor.number("svc.normal_sigma", svc.normal_sigma, 0, 1e6,
                 "equation 4.16: weight of the difference of normals");
  visitor.number("svc.curvature_sigma", svc.curvature_sigma, 0, 1e9,
                 "equation 4.16: weight of the product of curvatures");
  visitor.number("svc.utility_threshold", svc.utility_threshold, 0, 1e6,
                 "least utility of a cut (equation 4.19)");
  visitor.integer("svc.min_voxels", svc.min_voxels, 1, 1000000,
                  "voxels that a cut leaves on either side at least");

  visitor.number("convex_components.tolerance_rad", options.convex_components.tolerance_rad, 0,
                 2 * quarter_turn_rad, "concave angle up to which an edge connects, radians");

  auto& clean_up = options.clean_up;
  visitor.boolean("clean_up.join_across_borders", clean_up.join_across_borders,
                  "join neighbours whose common border gives no reason to part them");
  visitor.integer("clean_up.min_segment_points", clean_up.min_segment_points, 0, 1000000,
                  "smaller segments join a neighbour, or become label 0; 0: off");
  visitor.integer("clean_up.weak_border_points", clean_up.weak_border_points, 0, 1000000,
                  "smaller segments join a neighbour across a weak border; 0: off");

  auto& refine = options.refine;
  visitor.boolean("refine.boundary", refine.boundary, "refine borders point by point");
  visitor.integer("refine.mode_filter_radius", refine.mode_filter_radius, 0, 20,
                  "radius of the mode filter, pixels; 0: off");
  visitor.number("refine.mode_filter_depth_gate_m", refine.mode_filter_depth_gate_m, 0, 10,
                 "largest difference of depth in the mode filter, metres");

  visitor.number("describe.plane_distance_m", options.describe.plane_distance_m, 0, 10,
                 "largest distance of a point that is said to lie on the plane, metres");
}

}  // namespace cleave::segmentation
