// Prints a hash of the labels of a few scenes, for comparing builds of the library with each other.
#include <cstdint>
#include <cstdio>
#include <vector>

#include "depth_scene.hpp"
#include "segmentation/segmenter.hpp"

int main() {
  using namespace cleave::segmentation;
  constexpr std::uint64_t prime = 1099511628211;
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
    Segmenter segmenter(options);
    std::uint64_t hash = 14695981039346656037U;  // FNV-1a
    for (unsigned seed = 0; seed < 12; ++seed) {
      const DepthScene scene(seed);
      std::vector<std::uint16_t> labels(scene.view().size());
      Segmentation result;
      if (segmenter.segment(scene.view(), labels, result) != Outcome::segmented) return 1;
      for (const std::uint16_t label : labels) hash = (hash ^ label) * prime;
    }
    std::printf("%016llx\n", static_cast<unsigned long long>(hash));
  }
}
