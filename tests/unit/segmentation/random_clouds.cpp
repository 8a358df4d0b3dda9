// SPDX-License-Identifier: BSD-3-Clause
// random_clouds [COUNT [SEED]]: segments so many random clouds and checks what holds for any.
// Prints the seed of a cloud for which it does not, and exits with 1; a sanitizer finds the rest.
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "segmentation/view/measured.hpp"
#include "tests/unit/segmentation/support/random_cloud.hpp"
#include "tests/unit/segmentation/support/segment_cloud.hpp"

namespace {

using namespace cleave::segmentation;

Options random_options(RandomCloud& random) {
  Options options = random.one_in(5) == 0 ? thesis() : Options{};
  constexpr std::array algorithms = {Algorithm::ssc, Algorithm::ssc,
                                     Algorithm::ssc, Algorithm::constrained_ssc,
                                     Algorithm::svc, Algorithm::convex_components};
  options.algorithm = algorithms[random.one_in(algorithms.size())];
  if (random.one_in(4) == 0) options.representation = Representation::voxels;
  if (random.one_in(6) == 0) options.voxel.viewpoint = Viewpoint::single;
  if (random.one_in(6) == 0) options.voxel.viewpoint = Viewpoint::multiple;
  if (random.one_in(4) == 0) options.voxel.grid_offset = 0.5F;
  return options;
}

bool lies_inside(const ImageRectangle& r, const CloudView& cloud) {
  if (!cloud.organised()) return r.left + r.top + r.right + r.bottom == 0;
  return r.left < r.right && r.right <= cloud.width && r.top < r.bottom && r.bottom <= cloud.height;
}

bool is_sound(const Segment& segment, const CloudView& cloud) {
  constexpr float unit = 1e-3F;
  return segment.centroid.allFinite() && segment.box.centre.allFinite() &&
         segment.box.extent.allFinite() && segment.planarity >= 0 && segment.planarity <= 1 &&
         std::abs(segment.mean_normal.norm() - 1) < unit &&
         std::abs(segment.box.orientation.norm() - 1) < unit &&
         lies_inside(segment.rectangle, cloud);
}

// What is wrong; empty if nothing is.
std::string judge(const CloudView& cloud, const Segmented& result) {
  std::vector<std::uint32_t> count(result.segmentation.segments.size() + 1, 0);
  bool any = false;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const bool measured = is_measured(cloud.point(i));
    any = any || measured;
    if (result.labels[i] >= count.size()) return "a label without a segment";
    if (!measured && result.labels[i] != 0) return "a label where nothing was measured";
    ++count[result.labels[i]];
  }
  if ((result.outcome == Outcome::segmented) != any) return "an outcome that is not true";
  for (std::size_t label = 1; label < count.size(); ++label) {
    const Segment& segment = result.segmentation.segments[label - 1];
    if (segment.label != label || segment.point_count != count[label] || count[label] == 0) {
      return "a segment whose points are not those with its label";
    }
    if (label > 1 && count[label] > count[label - 1]) return "segments that are not sorted by size";
    if (!is_sound(segment, cloud)) return "a description that is not sound";
  }
  return "";
}

std::string try_cloud(std::uint64_t seed) {
  RandomCloud random(seed);
  const CloudView cloud = random.view();
  Segmenter segmenter(random_options(random));
  const Segmented first = segment(segmenter, cloud);
  const Segmented second = segment(segmenter, cloud);
  if (first.labels != second.labels) return "other labels in a second run";
  return judge(cloud, first);
}

}  // namespace

int main(int argc, char** argv) {
  const std::uint64_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 600;
  const std::uint64_t first = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const std::string problem = try_cloud(seed);
    if (problem.empty()) continue;
    std::printf("seed %llu: %s\n", static_cast<unsigned long long>(seed), problem.c_str());
    return EXIT_FAILURE;
  }
  std::printf("%llu clouds, from seed %llu\n", static_cast<unsigned long long>(count),
              static_cast<unsigned long long>(first));
  return EXIT_SUCCESS;
}
