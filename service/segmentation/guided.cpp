// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/guided.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "segmentation/graph/coarse_graph.hpp"
#include "segmentation/math/no_index.hpp"
#include "segmentation/option_checks.hpp"
#include "segmentation/partition/guided_cut.hpp"
#include "segmentation/partition/spectral_cuts.hpp"
#include "segmentation/path/path_finder.hpp"
#include "segmentation/path/path_options.hpp"

namespace cleave::segmentation {
namespace {

// The supervoxel of every point; no_index where nothing was measured. `path` has gathered the cloud
// and labelled it, each supervoxel as a segment of its own. Paths write 16 bits: supervoxels are
// written in turns.
std::vector<std::uint32_t> supervoxel_of_point(const SupervoxelPath& path, std::size_t points,
                                               std::size_t supervoxels) {
  constexpr std::size_t a_turn = std::numeric_limits<std::uint16_t>::max();
  std::vector<std::uint32_t> supervoxel(points, no_index);
  std::vector<std::uint16_t> written(points);
  for (std::size_t first = 0; first < supervoxels; first += a_turn) {
    std::vector<std::uint16_t> label(supervoxels, 0);
    const std::size_t count = std::min(a_turn, supervoxels - first);
    for (std::size_t i = 0; i < count; ++i) label[first + i] = static_cast<std::uint16_t>(i + 1);
    path.write_labels(label, written);
    for (std::size_t p = 0; p < points; ++p) {
      if (written[p] != 0) supervoxel[p] = static_cast<std::uint32_t>(first + written[p] - 1);
    }
    std::fill(written.begin(), written.end(), std::uint16_t{0});
  }
  return supervoxel;
}

// Objects numbered from 1 in the order of their labels; 0 stays 0.
std::vector<std::uint32_t> numbered(std::span<const std::uint32_t> truth) {
  std::vector<std::uint32_t> labels(truth.begin(), truth.end());
  labels.push_back(0);
  std::sort(labels.begin(), labels.end());
  labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
  std::vector<std::uint32_t> object(truth.size());
  std::transform(truth.begin(), truth.end(), object.begin(), [&](std::uint32_t label) {
    return static_cast<std::uint32_t>(std::lower_bound(labels.begin(), labels.end(), label) -
                                      labels.begin());
  });
  return object;
}

// `stored`, one a point of the cloud, for the points of the cloud as seen.
std::vector<std::uint32_t> in_seen_order(const std::vector<std::uint32_t>& stored,
                                         const SeenCloud& seen) {
  std::vector<std::uint32_t> values(stored.size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = stored[seen.stored_index(i)];
  return values;
}

// The object with most points of each supervoxel, the lowest among equals; 0 if no point has one.
std::vector<std::uint32_t> object_of_supervoxel(std::span<const std::uint32_t> object,
                                                std::span<const std::uint32_t> supervoxel_of_point,
                                                std::size_t supervoxels) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> members;  // supervoxel and object
  for (std::size_t p = 0; p < object.size(); ++p) {
    if (supervoxel_of_point[p] == no_index || object[p] == 0) continue;
    members.emplace_back(supervoxel_of_point[p], object[p]);
  }
  std::sort(members.begin(), members.end());
  std::vector<std::uint32_t> best(supervoxels, 0);
  std::vector<std::ptrdiff_t> most(supervoxels, 0);
  for (auto begin = members.begin(); begin != members.end();) {
    const auto end = std::upper_bound(begin, members.end(), *begin);
    if (end - begin > most[begin->first]) {
      most[begin->first] = end - begin;
      best[begin->first] = begin->second;
    }
    begin = end;
  }
  return best;
}

struct Scene {
  PathFinder path_finder;
  Supervoxels supervoxels;
  std::vector<SupervoxelEdge> edges;
  std::vector<std::uint32_t> supervoxel_of_point;
};

// False if no point was measured.
bool describe(const CloudView& cloud, const Options& options, Scene& scene) {
  SupervoxelPath* const path = scene.path_finder.gather(cloud, options);
  if (path == nullptr) return false;
  const Options on_path = options_on(*path, options);
  path->estimate_normals();
  path->cluster(on_path.supervoxel, scene.supervoxels);
  path->build_graph(scene.supervoxels, on_path, scene.edges);
  std::vector<std::uint32_t> itself(scene.supervoxels.size());
  std::iota(itself.begin(), itself.end(), 0U);
  path->label_points(scene.supervoxels, itself, {.boundary = false, .mode_filter_radius = 0});
  scene.supervoxel_of_point = supervoxel_of_point(*path, cloud.size(), itself.size());
  return true;
}

void check_sizes(const CloudView& cloud, std::span<const std::uint32_t> truth) {
  if (truth.size() == cloud.size()) return;
  std::ostringstream message;
  message << "cannot guide the segmentation of " << cloud.size() << " points by " << truth.size()
          << " true labels; give one label a point";
  throw std::invalid_argument(message.str());
}

}  // namespace

GuidedSegmentation segment_guided(const CloudView& cloud, std::span<const std::uint32_t> truth,
                                  const Options& options) {
  check_options(options);
  check_sizes(cloud, truth);
  Options on_supervoxels = options;
  on_supervoxels.algorithm = Algorithm::ssc;  // whatever cuts their graph afterwards
  Scene scene;
  if (!describe(cloud, on_supervoxels, scene)) return {};
  const auto count = static_cast<std::uint32_t>(scene.supervoxels.size());
  const auto object = object_of_supervoxel(in_seen_order(numbered(truth), scene.path_finder.seen()),
                                           scene.supervoxel_of_point, count);

  GraphCoarsener coarsener;
  (void)coarsener.coarsen(count, scene.edges, 0);  // leaves every supervoxel its own vertex
  GuidedCutFinder finder;
  finder.start(object, scene.supervoxels.point_count);
  std::vector<std::uint32_t> segment;
  (void)SpectralCutter().cut(count, coarsener.edges(),
                             {.eigenvectors = options.partition.eigenvectors,
                              .utility_threshold = 0,
                              .decomposition = options.partition.decomposition,
                              .laplacian = {.normalisation = options.partition.laplacian}},
                             finder, segment);

  std::vector<std::uint32_t> objects = object;
  std::sort(objects.begin(), objects.end());
  objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
  std::erase(objects, 0U);
  return {.cuts = finder.cuts(), .objects = static_cast<std::uint32_t>(objects.size())};
}

}  // namespace cleave::segmentation
