#include "segmentation/segmenter.hpp"

#include <algorithm>
#include <limits>

#include "segmentation/adjacency.hpp"
#include "segmentation/boundary_refinement.hpp"
#include "segmentation/canonical_labels.hpp"
#include "segmentation/cell_path.hpp"
#include "segmentation/clean_up.hpp"
#include "segmentation/mode_filter.hpp"
#include "segmentation/normals.hpp"
#include "segmentation/option_checks.hpp"
#include "segmentation/partition.hpp"
#include "segmentation/point_set.hpp"
#include "segmentation/segment_borders.hpp"
#include "segmentation/segment_shapes.hpp"
#include "segmentation/supervoxel_clustering.hpp"
#include "segmentation/supervoxel_graph.hpp"
#include "segmentation/supervoxels.hpp"
#include "segmentation/voxel_grid.hpp"
#include "segmentation/voxel_neighbours.hpp"

namespace cleave::segmentation {

// The steps, and what they hand on. A step overwrites all of its output: nothing of a frame is left
// for the next but memory.
struct Segmenter::Workspace {
  Voxeliser voxeliser;
  NormalEstimator normal_estimator;
  SupervoxelClusterer clusterer;
  SupervoxelFitter fitter;
  AdjacencyFinder adjacency_finder;
  Partitioner partitioner;
  SmallSegmentMerger merger;
  BoundaryRefiner boundary_refiner;
  ModeFilter mode_filter;
  LabelOrder label_order;
  CellPath cell_path;
  ShapeDescriber shape_describer;
  BorderDescriber border_describer;

  PointSet points;
  bool on_cells = false;  // or else on voxels
  VoxelGrid grid;
  NeighbourLists neighbours;   // of voxels
  std::vector<Surfel> voxels;  // of the grid
  Supervoxels supervoxels;
  std::vector<AdjacentPair> adjacent_pairs;
  std::vector<SupervoxelEdge> edges;
  std::uint32_t segments = 0;
  std::vector<std::uint32_t> segment_of_supervoxel, segment_of_point;
  std::vector<std::uint16_t> label_of_segment, label_of_point;
  SegmentImage image;

  void voxelise(const CloudView& cloud, const Options& options);
  void estimate_normals();
  void cluster_supervoxels(const SupervoxelOptions& options);
  void build_graph(const GraphOptions& options);
  void label_points(const CloudView& cloud, const RefineOptions& options,
                    std::span<std::uint16_t> labels);
  void label_voxels(const CloudView& cloud, const RefineOptions& options);
  void filter_image(const CloudView& cloud, const RefineOptions& options);
  void describe(const CloudView& cloud, const DescribeOptions& options, Segmentation& result);
};

void Segmenter::Workspace::voxelise(const CloudView& cloud, const Options& options) {
  on_cells =
      options.representation == Representation::cells && cell_path.gather(cloud, options.voxel);
  if (on_cells) return;
  voxeliser.voxelise(points, options.voxel, grid);
  find_voxel_neighbours(grid, neighbours);
}

void Segmenter::Workspace::estimate_normals() {
  if (on_cells) return cell_path.estimate_normals();
  normal_estimator.estimate(grid.centroid, neighbours, voxels);
}

void Segmenter::Workspace::cluster_supervoxels(const SupervoxelOptions& options) {
  if (on_cells) return cell_path.cluster(options, supervoxels);
  const std::uint32_t count = clusterer.cluster(voxels, neighbours, options, supervoxels.of_voxel);
  fitter.fit(grid, voxels, count, options.refit_from_points, supervoxels);
}

void Segmenter::Workspace::build_graph(const GraphOptions& options) {
  if (on_cells) {
    cell_path.find_adjacent_pairs(adjacent_pairs);
  } else {
    adjacency_finder.find(supervoxels.of_voxel, neighbours, adjacent_pairs);
  }
  build_supervoxel_graph(adjacent_pairs, supervoxels.surfel, options, edges);
}

void Segmenter::Workspace::filter_image(const CloudView& cloud, const RefineOptions& options) {
  image.width = cloud.width;
  image.height = cloud.height;
  image.segment.assign(cloud.size(), SegmentImage::no_segment);
  image.depth_m.assign(cloud.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    image.segment[points.index[i]] = segment_of_point[i];
    image.depth_m[points.index[i]] = points.z[i];
  }
  mode_filter.filter(image, options.mode_filter_radius, options.mode_filter_depth_gate_m);
  for (std::size_t i = 0; i < points.size(); ++i) {
    segment_of_point[i] = image.segment[points.index[i]];
  }
}

void Segmenter::Workspace::label_voxels(const CloudView& cloud, const RefineOptions& options) {
  for (std::size_t run = 0; run < grid.runs(); ++run) {
    const std::uint32_t supervoxel = supervoxels.of_voxel[grid.run_voxel[run]];
    std::fill(segment_of_point.begin() + grid.run_begin[run],
              segment_of_point.begin() + grid.run_begin[run + 1],
              segment_of_supervoxel[supervoxel]);
  }
  if (options.boundary) {
    boundary_refiner.refine(points, grid, neighbours, supervoxels, segment_of_supervoxel,
                            segment_of_point);
  }
  if (options.mode_filter_radius > 0 && cloud.organised()) filter_image(cloud, options);
}

void Segmenter::Workspace::label_points(const CloudView& cloud, const RefineOptions& options,
                                        std::span<std::uint16_t> labels) {
  segment_of_point.resize(points.size());
  if (on_cells) {
    cell_path.label_points(cloud, supervoxels, segment_of_supervoxel, options);
    const auto& segment = cell_path.image().segment;
    for (std::size_t i = 0; i < points.size(); ++i) {
      segment_of_point[i] = segment[points.index[i]];
    }
  } else {
    label_voxels(cloud, options);
  }

  label_order.order(segment_of_point, segments, label_of_segment);
  label_of_point.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    label_of_point[i] = label_of_segment[segment_of_point[i]];
    labels[points.index[i]] = label_of_point[i];
  }
}

void Segmenter::Workspace::describe(const CloudView& cloud, const DescribeOptions& options,
                                    Segmentation& result) {
  if (on_cells) cell_path.list_as_voxels(points, grid, voxels);
  shape_describer.describe(cloud, points, grid, voxels, label_of_point, options, result.segments);
  border_describer.describe(edges, segment_of_supervoxel, label_of_segment, result.borders);
}

namespace {

bool has_sound_sizes(const CloudView& cloud, std::size_t labels) {
  return cloud.size() == labels && cloud.size() < std::numeric_limits<std::uint32_t>::max() &&
         (cloud.size() == 0 || (cloud.xyz != nullptr && cloud.stride >= 3));
}

}  // namespace

Segmenter::Segmenter(const Options& options)
    : options_(options), workspace_(std::make_unique<Workspace>()) {
  check_options(options);
}
Segmenter::~Segmenter() = default;
Segmenter::Segmenter(Segmenter&&) noexcept = default;
Segmenter& Segmenter::operator=(Segmenter&&) noexcept = default;

Outcome Segmenter::segment(const CloudView& cloud, std::span<std::uint16_t> labels,
                           Segmentation& result, StageObserver* observer) {
  Workspace& w = *workspace_;
  const auto ended = [observer](Stage stage) {
    if (observer != nullptr) observer->stage_ended(stage);
  };
  std::fill(labels.begin(), labels.end(), std::uint16_t{0});
  result.segments.clear();
  result.borders.clear();
  if (!has_sound_sizes(cloud, labels.size())) return Outcome::bad_size;
  gather_finite_points(cloud, w.points);
  if (w.points.size() == 0) return Outcome::no_finite_point;

  w.voxelise(cloud, options_);
  ended(Stage::voxelise);

  w.estimate_normals();
  ended(Stage::normals);

  w.cluster_supervoxels(options_.supervoxel);
  ended(Stage::supervoxels);

  w.build_graph(options_.graph);
  ended(Stage::graph);

  w.segments = w.partitioner.partition(static_cast<std::uint32_t>(w.supervoxels.size()), w.edges,
                                       options_.partition, w.segment_of_supervoxel);
  ended(Stage::partition);

  w.merger.merge(w.edges, w.supervoxels.point_count, w.segments,
                 options_.clean_up.min_segment_points, w.segment_of_supervoxel);
  ended(Stage::clean_up);

  w.label_points(cloud, options_.refine, labels);
  ended(Stage::label_points);

  w.describe(cloud, options_.describe, result);
  ended(Stage::describe);
  return Outcome::segmented;
}

const char* to_string(Stage stage) {
  switch (stage) {
    case Stage::voxelise:
      return "voxelise";
    case Stage::normals:
      return "normals";
    case Stage::supervoxels:
      return "supervoxels";
    case Stage::graph:
      return "graph";
    case Stage::partition:
      return "partition";
    case Stage::clean_up:
      return "clean_up";
    case Stage::label_points:
      return "label_points";
    case Stage::describe:
      return "describe";
  }
  return "unknown";
}

}  // namespace cleave::segmentation
