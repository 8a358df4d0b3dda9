#include "segmentation/segmenter.hpp"

#include <algorithm>
#include <limits>

#include "segmentation/border_joining.hpp"
#include "segmentation/canonical_labels.hpp"
#include "segmentation/cell_path.hpp"
#include "segmentation/clean_up.hpp"
#include "segmentation/dust/dust_settler.hpp"
#include "segmentation/graph_partition.hpp"
#include "segmentation/option_checks.hpp"
#include "segmentation/segment_borders.hpp"
#include "segmentation/segment_shapes.hpp"
#include "segmentation/spacing/spacing_options.hpp"
#include "segmentation/supervoxel_graph.hpp"
#include "segmentation/view/seen_cloud.hpp"
#include "segmentation/voxel_path.hpp"

namespace cleave::segmentation {

// The steps, and what they hand on. A step overwrites all of its output: nothing of a frame is left
// for the next but memory.
struct Segmenter::Workspace {
  SeenCloud seen;
  VoxelPath voxel_path;
  CellPath cell_path;
  GraphPartitioner partitioner;
  BorderJoiner joiner;
  SmallSegmentMerger merger;
  DustSettler dust_settler;
  LabelOrder label_order;
  ShapeDescriber shape_describer;
  BorderDescriber border_describer;

  bool on_cells = false;  // or else on voxels
  Supervoxels supervoxels;
  std::vector<AdjacentPair> adjacent_pairs;
  GraphOptions graph_options;  // for this frame
  std::vector<SupervoxelEdge> edges;
  std::uint32_t segments = 0;
  std::vector<std::uint32_t> segment_of_supervoxel;
  std::vector<std::uint32_t> settled;  // of a segment: the one that its points belong to
  std::vector<std::uint16_t> label_of_segment;
  Surface surface;

  bool gather(const CloudView& cloud, const Options& options);
  void estimate_normals();
  void cluster_supervoxels(const Options& options);
  void build_graph(const Options& options);
  void clean_up(const Options& options);
  bool label_points(const Options& options, std::span<std::uint16_t> labels);
  void describe(const DescribeOptions& options, Segmentation& result);
  [[nodiscard]] CloudSpacing spacing() const {
    return on_cells ? cell_path.spacing() : voxel_path.spacing();
  }
  [[nodiscard]] SegmentedPoints points() const {
    return on_cells ? cell_path.points() : voxel_path.points();
  }
};

bool Segmenter::Workspace::gather(const CloudView& cloud, const Options& options) {
  const bool wants_cells =
      options.algorithm != Algorithm::svc && options.representation == Representation::cells;
  const bool is_image = options.voxel.viewpoint != Viewpoint::multiple && seen.look_at_image(cloud);
  on_cells = wants_cells && is_image && cell_path.gather(seen.cloud(), options.voxel);
  if (on_cells) return true;
  if (!is_image || wants_cells) seen.look_at_points(cloud, options.voxel.viewpoint);
  VoxelOptions voxel = options.voxel;
  voxel.viewpoint = seen.from_one_viewpoint() ? Viewpoint::single : Viewpoint::multiple;
  if (options.algorithm == Algorithm::svc && voxel.neighbourhood == Neighbourhood::automatic) {
    voxel.neighbourhood = Neighbourhood::edges;
  }
  return voxel_path.gather(seen.cloud(), voxel);
}

void Segmenter::Workspace::estimate_normals() {
  on_cells ? cell_path.estimate_normals() : voxel_path.estimate_normals();
}

void Segmenter::Workspace::cluster_supervoxels(const Options& options) {
  if (options.algorithm == Algorithm::svc) {
    voxel_path.take_voxels_as_supervoxels(supervoxels);
    return;
  }
  on_cells ? cell_path.cluster(options.supervoxel, supervoxels)
           : voxel_path.cluster(options.supervoxel, supervoxels);
}

void Segmenter::Workspace::build_graph(const Options& options) {
  if (options.algorithm == Algorithm::svc) {
    voxel_path.build_voxel_graph(options.svc, edges);
    return;
  }
  on_cells ? cell_path.find_adjacent_pairs(supervoxels, adjacent_pairs)
           : voxel_path.find_adjacent_pairs(supervoxels, adjacent_pairs);
  graph_options = options.graph;
  // What a step in depth means is known for a sensor in the origin only.
  if (!on_cells && !voxel_path.seen_from_one_viewpoint()) graph_options.max_step_m = 0;
  build_supervoxel_graph(adjacent_pairs, supervoxels.surfel, graph_options, edges);
}

// What follows a spectral partition. Voxels and convex components are other methods: they get what
// the thesis gives them, and slivers are merged.
void Segmenter::Workspace::clean_up(const Options& options) {
  CleanUpOptions clean_up = options.clean_up;
  if (options.algorithm == Algorithm::svc || options.algorithm == Algorithm::convex_components) {
    clean_up.join_across_borders = false;
    clean_up.weak_border_points = 0;
  }
  if (clean_up.join_across_borders) {
    joiner.join(edges, supervoxels.surfel, graph_options, segments, segment_of_supervoxel);
  }
  merger.merge(edges, supervoxels.point_count, segments, clean_up, segment_of_supervoxel);
}

// False if there are more segments than labels.
bool Segmenter::Workspace::label_points(const Options& options, std::span<std::uint16_t> labels) {
  on_cells
      ? cell_path.label_points(supervoxels, segment_of_supervoxel, options.refine)
      : voxel_path.label_points(seen.cloud(), supervoxels, segment_of_supervoxel, options.refine);
  dust_settler.settle(*points().runs, edges, segment_of_supervoxel, segments,
                      options.clean_up.min_segment_points, settled);
  if (!label_order.order(*points().runs, settled, label_of_segment)) return false;
  const std::span<std::uint16_t> seen_labels = seen.labels(labels);
  on_cells ? cell_path.write_labels(label_of_segment, seen_labels)
           : voxel_path.write_labels(label_of_segment, seen_labels);
  return true;
}

void Segmenter::Workspace::describe(const DescribeOptions& options, Segmentation& result) {
  on_cells ? cell_path.list_surface(segment_of_supervoxel, surface)
           : voxel_path.list_surface(surface);
  shape_describer.describe(points(), surface, seen.cloud().organised(), label_of_segment, options,
                           result.segments);
  border_describer.describe(edges, segment_of_supervoxel, label_of_segment, result.borders);
  for (const PointRun& run : *points().runs) result.measured_points += run.end - run.begin;
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
  result.measured_points = 0;
  if (!has_sound_sizes(cloud, labels.size())) return Outcome::bad_size;

  if (!w.gather(cloud, options_)) return Outcome::no_finite_point;
  const Options options = options_for_spacing(options_, w.spacing());
  ended(Stage::voxelise);

  w.estimate_normals();
  ended(Stage::normals);

  w.cluster_supervoxels(options);
  ended(Stage::supervoxels);

  w.build_graph(options);
  ended(Stage::graph);

  w.segments = w.partitioner.partition(static_cast<std::uint32_t>(w.supervoxels.size()), w.edges,
                                       options, w.segment_of_supervoxel);
  ended(Stage::partition);

  w.clean_up(options);
  ended(Stage::clean_up);

  if (!w.label_points(options, labels)) return Outcome::too_many_segments;
  ended(Stage::label_points);

  w.describe(options.describe, result);
  w.seen.give_back(labels, result);
  ended(Stage::describe);
  return Outcome::segmented;
}

}  // namespace cleave::segmentation
