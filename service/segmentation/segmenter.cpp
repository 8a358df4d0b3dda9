// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/segmenter.hpp"

#include <algorithm>
#include <limits>

#include "segmentation/clean_up/canonical_labels.hpp"
#include "segmentation/clean_up/dust_settler.hpp"
#include "segmentation/clean_up/segment_cleaner.hpp"
#include "segmentation/describe/segment_borders.hpp"
#include "segmentation/describe/segment_shapes.hpp"
#include "segmentation/option_checks.hpp"
#include "segmentation/partition/graph_partition.hpp"
#include "segmentation/path/path_finder.hpp"
#include "segmentation/path/path_options.hpp"

namespace cleave::segmentation {

// The steps, and what they hand on. A step overwrites all of its output: nothing of a frame is left
// for the next but memory.
struct Segmenter::Workspace {
  PathFinder path_finder;
  GraphPartitioner partitioner;
  SegmentCleaner cleaner;
  DustSettler dust_settler;
  LabelOrder label_order;
  ShapeDescriber shape_describer;
  BorderDescriber border_describer;

  Supervoxels supervoxels;
  std::vector<SupervoxelEdge> edges;
  std::uint32_t segments = 0;
  std::vector<std::uint32_t> segment_of_supervoxel;
  std::vector<std::uint32_t> settled;  // of a segment: the one that its points belong to
  std::vector<std::uint16_t> label_of_segment;
  Surface surface;

  bool label_points(SupervoxelPath& path, const Options& options, std::span<std::uint16_t> labels);
  void describe(const SupervoxelPath& path, const DescribeOptions& options, Segmentation& result);
};

// False if there are more segments than labels.
bool Segmenter::Workspace::label_points(SupervoxelPath& path, const Options& options,
                                        std::span<std::uint16_t> labels) {
  path.label_points(supervoxels, segment_of_supervoxel, options.refine);
  const std::vector<PointRun>& runs = *path.points().runs;
  dust_settler.settle(runs, edges, segment_of_supervoxel, segments,
                      options.clean_up.min_segment_points, settled);
  if (!label_order.order(runs, settled, label_of_segment)) return false;
  path.write_labels(label_of_segment, path_finder.seen().labels(labels));
  return true;
}

void Segmenter::Workspace::describe(const SupervoxelPath& path, const DescribeOptions& options,
                                    Segmentation& result) {
  path.list_surface(segment_of_supervoxel, surface);
  shape_describer.describe(path.points(), surface, path_finder.seen().cloud().organised(),
                           label_of_segment, options, result.segments);
  border_describer.describe(edges, segment_of_supervoxel, label_of_segment, result.borders);
  for (const PointRun& run : *path.points().runs) result.measured_points += run.end - run.begin;
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

  SupervoxelPath* const path = w.path_finder.gather(cloud, options_);
  if (path == nullptr) return Outcome::no_finite_point;
  const Options options = options_on(*path, options_);
  ended(Stage::voxelise);

  path->estimate_normals();
  ended(Stage::normals);

  path->cluster(options.supervoxel, w.supervoxels);
  ended(Stage::supervoxels);

  path->build_graph(w.supervoxels, options, w.edges);
  ended(Stage::graph);

  w.segments = w.partitioner.partition(static_cast<std::uint32_t>(w.supervoxels.size()), w.edges,
                                       options, w.segment_of_supervoxel);
  ended(Stage::partition);

  w.cleaner.clean(w.edges, w.supervoxels.surfel, w.supervoxels.point_count, w.segments, options,
                  w.segment_of_supervoxel);
  ended(Stage::clean_up);

  if (!w.label_points(*path, options, labels)) return Outcome::too_many_segments;
  ended(Stage::label_points);

  w.describe(*path, options.describe, result);
  w.path_finder.seen().give_back(labels, result);
  ended(Stage::describe);
  return Outcome::segmented;
}

}  // namespace cleave::segmentation
