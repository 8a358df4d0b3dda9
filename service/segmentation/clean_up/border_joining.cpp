// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/clean_up/border_joining.hpp"

#include <algorithm>

#include "segmentation/graph/edge_heuristics.hpp"

namespace cleave::segmentation {
namespace {

// The numbers were fitted to labelled scenes; QUALITY.md says what each of the three rules is
// worth.

// Summed weight of edges; a convex one has 1. With less, a border has hardly a link to judge by.
constexpr double min_link_weight = 0.9;
// Utility of the whole border as a cut (equation 4.8): well below that from which cuts are made,
// partition.utility_threshold, as a border along which a cut was found looks worse than it is.
constexpr double max_utility_of_border = 0.3;

// Touching voxels or cells. Two surfaces that only happen to touch do so along fewer.
constexpr double min_convex_length = 8;
// Of the length; noise in the normals makes the rest look concave.
constexpr double min_convex_share = 0.8;
// Mean step along the border, in graph.max_step_m. Patches on both sides of a convex crease are off
// each other's planes by more than patches of one plane; more still, and one side lies behind.
constexpr float max_steps_of_crease = 5;

// Of the length. Where less of it links, other evidence parts the two.
constexpr double min_linking_share = 0.5;
// How many times more than inside a hollow may bend at the border: cuts run where it bends most.
constexpr double sharper_at_a_cut = 2;
// 1/m. What noise in the normals adds to a curvature: half a right angle over 4 cm.
constexpr double noise_per_metre = 20;

struct Bend {
  double bend, square;
};

// How much the normals of two patches spread over their distance; negative where it is concave.
Bend bend_between(const Surfel& i, const Surfel& j) {
  const Eigen::Vector3f way = j.position - i.position;
  return {double{(j.normal - i.normal).dot(way)}, double{way.squaredNorm()}};
}

}  // namespace

void BorderJoiner::pool(const std::vector<SupervoxelEdge>& edges,
                        const std::vector<Surfel>& supervoxels, std::uint32_t segments,
                        const std::vector<std::uint32_t>& segment) {
  inside_.assign(segments, Curvature{});
  pair_.clear();
  edge_.clear();
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    const SupervoxelEdge& edge = edges[e];
    const auto [low, high] = std::minmax(segment[edge.first], segment[edge.second]);
    if (low != high) {
      pair_.push_back((std::uint64_t{low} << 32) | high);
      edge_.push_back(e);
    } else if (edge.valid) {
      const Bend b = bend_between(supervoxels[edge.first], supervoxels[edge.second]);
      inside_[low].bend += edge.touching_voxels * b.bend;
      inside_[low].square += edge.touching_voxels * b.square;
    }
  }

  ranking_.rank(pair_);
  border_.assign(ranking_.distinct_keys().size(), Border{});
  for (std::size_t i = 0; i < edge_.size(); ++i) {
    const SupervoxelEdge& edge = edges[edge_[i]];
    const Surfel& first = supervoxels[edge.first];
    const Surfel& second = supervoxels[edge.second];
    const double length = edge.touching_voxels;
    const double depth_m = (first.position.z() + second.position.z()) / 2;
    Border& border = border_[ranking_.rank_of_item()[i]];
    border.length += length;
    border.step_m += length * step_m(first, second) / (depth_m * depth_m);
    if (edge.convex) border.convex += length;
    if (!edge.valid) continue;
    if (!edge.is_cannot_link()) border.linking += length;
    border.weight += edge.weight;
    border.cannot_links += edge.cannot_link_share;
    const Bend b = bend_between(first, second);
    if (!(b.square > 0)) continue;
    border.curvature += length * b.bend / b.square;
    border.curved_length += length;
  }
}

bool BorderJoiner::is_worth_no_cut(const Border& border) {
  return border.weight > min_link_weight &&
         border.cannot_links < max_utility_of_border * border.weight;
}

bool BorderJoiner::is_convex(const Border& border, const GraphOptions& graph) {
  if (border.length <= min_convex_length) return false;
  if (border.convex <= min_convex_share * border.length) return false;
  return !(graph.max_step_m > 0) ||
         border.step_m < max_steps_of_crease * graph.max_step_m * border.length;
}

bool BorderJoiner::is_hollow(const Border& border, const Curvature& a, const Curvature& b) {
  if (!a.known() || !b.known() || !(border.curved_length > 0)) return false;
  const double less_hollow = std::max(a.per_metre(), b.per_metre());
  const double across = border.curvature / border.curved_length;
  return less_hollow < 0 && border.linking > min_linking_share * border.length &&
         across > sharper_at_a_cut * less_hollow - noise_per_metre;
}

void BorderJoiner::join(const std::vector<SupervoxelEdge>& edges,
                        const std::vector<Surfel>& supervoxels, const GraphOptions& graph,
                        std::uint32_t segments, std::vector<std::uint32_t>& segment) {
  pool(edges, supervoxels, segments, segment);
  joined_.reset(segments);
  for (std::size_t i = 0; i < border_.size(); ++i) {
    const std::uint64_t pair = ranking_.distinct_keys()[i];
    const auto low = static_cast<std::uint32_t>(pair >> 32);
    const auto high = static_cast<std::uint32_t>(pair);
    const Border& border = border_[i];
    if (!is_worth_no_cut(border) && !is_convex(border, graph) &&
        !is_hollow(border, inside_[low], inside_[high])) {
      continue;
    }
    joined_.join(low, high);
  }
  for (std::uint32_t& s : segment) s = joined_.root(s);
}

}  // namespace cleave::segmentation
