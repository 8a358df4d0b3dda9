// SPDX-License-Identifier: BSD-3-Clause
// Prints a hash of the labels of a few scenes, for comparing builds of the library with each other.
#include <cstdint>
#include <cstdio>
#include <vector>

#include "segmentation/segmenter.hpp"
#include "tests/unit/segmentation/support/depth_scene.hpp"
#include "tests/unit/segmentation/support/table_cloud.hpp"
#include "tests/unit/segmentation/view/stored_scene.hpp"

namespace {

using namespace cleave::segmentation;

// Prints the hash of all labels of `clouds`; false if one cannot be segmented.
template <class Clouds>
bool print_hash(const Options& options, const Clouds& clouds) {
  constexpr std::uint64_t prime = 1099511628211;
  Segmenter segmenter(options);
  std::uint64_t hash = 14695981039346656037U;  // FNV-1a
  for (const auto& cloud : clouds) {
    std::vector<std::uint16_t> labels(cloud.view().size());
    Segmentation result;
    if (segmenter.segment(cloud.view(), labels, result) != Outcome::segmented) return false;
    for (const std::uint16_t label : labels) hash = (hash ^ label) * prime;
  }
  std::printf("%016llx\n", static_cast<unsigned long long>(hash));
  return true;
}

}  // namespace

int main() {
  std::vector<DepthScene> scenes;
  for (unsigned seed = 0; seed < 12; ++seed) scenes.emplace_back(seed);
  const auto with = [](Representation representation, Algorithm algorithm) {
    Options options;
    options.representation = representation;
    options.algorithm = algorithm;
    return options;
  };
  Options others = with(Representation::voxels, Algorithm::ssc);
  others.graph.weight = WeightFunction::gaussian;
  others.graph.weight_sigma = 0.1F;
  others.graph.convexity = Convexity::lai;
  others.partition.laplacian = Laplacian::random_walk;
  for (const Options& options :
       {with(Representation::cells, Algorithm::ssc), with(Representation::voxels, Algorithm::ssc),
        with(Representation::cells, Algorithm::constrained_ssc),
        with(Representation::cells, Algorithm::convex_components),
        with(Representation::voxels, Algorithm::svc), others}) {
    if (!print_hash(options, scenes)) return 1;
  }
  std::vector<TableCloud> tables;
  for (const float spacing : {0.008F, 0.01F, 0.02F, 0.5F}) tables.emplace_back(spacing);
  return print_hash({}, tables) && print_hash({}, scenes_on_a_robot()) ? 0 : 1;
}
