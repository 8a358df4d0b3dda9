// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/ignored_options.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "segmentation/option_visitor.hpp"
#include "sensor/renderer/scene/scene_loop.hpp"
#include "tests/unit/segmentation/support/segmented.hpp"

namespace cleave::segmentation {
namespace {

const std::array ours = {Options{}};
const std::array thesis_alone = {thesis()};

// Sets the option of a name to another value, one of a few; remembers all names.
struct OptionChanger {
  static constexpr std::size_t values = 4;
  std::string_view name;
  std::size_t value = 0;
  std::vector<std::string> names = {};

  void number(std::string_view option, float& current, double min, double max, std::string_view) {
    if (!is_meant(option)) return;
    const double old = double{current};
    const double less = old > 0 ? old / 3 : max / 1000;  // switches on what is off by default
    current = static_cast<float>(std::array{std::min(3 * old, max), less, max, min}[value]);
  }
  void integer(std::string_view option, std::uint32_t& current, std::uint32_t min,
               std::uint32_t max, std::string_view) {
    if (!is_meant(option)) return;
    current = std::array{std::min(3 * current + 1, max), min, min + 1, max}[value];
  }
  void boolean(std::string_view option, bool& current, std::string_view) {
    if (is_meant(option)) current = !current;
  }
  template <typename Choices>
  void choice(std::string_view option, std::size_t& index, const Choices& choices,
              std::string_view) {
    if (is_meant(option)) index = (index + 1 + value) % choices.size();
  }

 private:
  bool is_meant(std::string_view option) {
    names.emplace_back(option);
    return option == name;
  }
};

std::vector<std::string> option_names() {
  Options options;
  OptionChanger changer{.name = ""};
  visit_options(options, changer);
  return changer.names;
}

Options changed(Options options, std::string_view name, std::size_t value) {
  visit_options(options, OptionChanger{.name = name, .value = value});
  return options;
}

bool same(const Segmented& a, const Segmented& b) {
  const auto same_segment = [](const Segment& s, const Segment& t) {
    return s.planarity == t.planarity && s.point_count == t.point_count;
  };
  const auto same_border = [](const Border& s, const Border& t) {
    return s.first == t.first && s.second == t.second && s.kind == t.kind;
  };
  return a.labels == b.labels &&
         std::ranges::equal(a.segmentation.segments, b.segmentation.segments, same_segment) &&
         std::ranges::equal(a.segmentation.borders, b.segmentation.borders, same_border);
}

// A crowded scene in `scale` times 640 x 480 pixels, and what a method makes of it.
struct CrowdedImage {
  std::uint32_t width = 0, height = 0;
  std::vector<float> xyz;
  Segmented result;

  CrowdedImage(std::uint32_t seed, double scale, const Options& options) {
    const render::CameraModel camera = render::scaled({}, scale);
    const auto request = render::parse_scene("crowded?seed=" + std::to_string(seed));
    const render::LabelledDepth image = render::SceneLoop(request, camera).frame(0);
    width = image.width;
    height = image.height;
    xyz = render::to_points(image, camera.intrinsics);
    result = segmented(view(), options);
  }
  [[nodiscard]] CloudView view() const { return {xyz.data(), 3, width, height}; }
};

struct Choice {
  const char* name;
  Algorithm algorithm;
  Representation representation;
};

class EveryOption : public testing::TestWithParam<Choice> {
 protected:
  EveryOption() {
    options_.algorithm = GetParam().algorithm;
    options_.representation = GetParam().representation;
  }
  // Scene after scene, as many as it takes: Lai's convexity, say, decides few edges otherwise.
  [[nodiscard]] bool counts(std::string_view name) {
    constexpr std::size_t enough_scenes = 30;
    for (std::size_t scene = 0; scene < enough_scenes; ++scene) {
      if (scene == scenes_.size()) {
        scenes_.emplace_back(8001 + scene, scene == 0 ? 0.25 : 0.5, options_);
      }
      const CrowdedImage& image = scenes_[scene];
      for (std::size_t value = 0; value < OptionChanger::values; ++value) {
        const Segmented result = segmented(image.view(), changed(options_, name, value));
        if (!same(result, image.result)) return true;
      }
    }
    return false;
  }

  Options options_;
  std::vector<CrowdedImage> scenes_;
};

TEST_P(EveryOption, IsRefusedOrMakesADifference) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "many segmentations, of kinds that other tests run under the sanitizers";
#endif
  for (const std::string& name : option_names()) {
    if (name == "algorithm") continue;
    if (find_ignored_option(changed(options_, name, 0), ours)) continue;
    EXPECT_TRUE(counts(name)) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Of, EveryOption,
    testing::Values(
        Choice{"SscOnCells", Algorithm::ssc, Representation::cells},
        Choice{"SscOnVoxels", Algorithm::ssc, Representation::voxels},
        Choice{"ConstrainedSscOnCells", Algorithm::constrained_ssc, Representation::cells},
        Choice{"Svc", Algorithm::svc, Representation::cells},
        Choice{"ConvexComponentsOnCells", Algorithm::convex_components, Representation::cells}),
    [](const auto& choice) { return choice.param.name; });

constexpr std::array every_algorithm = {Algorithm::ssc, Algorithm::constrained_ssc, Algorithm::svc,
                                        Algorithm::convex_components};

std::string ignored_in(const Options& options, std::span<const Options> presets = ours) {
  const auto ignored = find_ignored_option(options, presets);
  return ignored ? ignored->name + "=" + ignored->value : "";
}

TEST(IgnoredOptions, AreNotThoseThatAPresetSetsForOtherAlgorithms) {
  for (const auto& preset : {ours, thesis_alone}) {
    Options options = preset.front();
    for (const Algorithm algorithm : every_algorithm) {
      options.algorithm = algorithm;
      EXPECT_EQ(ignored_in(options, preset), "");
    }
  }
}

TEST(IgnoredOptions, AreFoundOnTopOfEitherPreset) {
  Options options;
  options.algorithm = Algorithm::svc;
  options.supervoxel.refit_from_points = false;
  EXPECT_EQ(ignored_in(options), "supervoxel.refit_from_points=false");

  options = thesis();
  options.algorithm = Algorithm::svc;
  options.graph.max_step_m = 0.01F;
  EXPECT_EQ(ignored_in(options, thesis_alone), "graph.max_step_m=0.01");

  options = thesis();
  options.partition.cannot_link_weight = 2;
  EXPECT_EQ(ignored_in(options, thesis_alone), "partition.cannot_link_weight=2");
}

TEST(IgnoredOptions, AreNoneThatNobodyHasSet) {
  // More of the thesis's values than of ours, set one by one on top of ours.
  Options options = thesis();
  options.algorithm = Algorithm::svc;
  options.representation = Options{}.representation;
  options.supervoxel = Options{}.supervoxel;
  options.graph = Options{}.graph;
  options.partition.cannot_link_weight = Options{}.partition.cannot_link_weight;
  options.partition.coarsening_rounds = Options{}.partition.coarsening_rounds;
  options.partition.utility_threshold = Options{}.partition.utility_threshold;
  options.convex_components = Options{}.convex_components;
  options.clean_up = Options{}.clean_up;
  EXPECT_EQ(ignored_in(options), "");
}

TEST(IgnoredOptions, OfAPresetThatIsNotKnownAreAsNeitherHasThem) {
  const std::array either = {Options{}, thesis()};
  Options options;
  options.algorithm = Algorithm::svc;
  options.supervoxel.refit_from_points = false;
  EXPECT_EQ(ignored_in(options, either), "");
  options.graph.max_step_m = 0.01F;
  EXPECT_EQ(ignored_in(options, either), "graph.max_step_m=0.01");
}

TEST(IgnoredOptions, HoldTheRepresentationOfAnAlgorithmThatCutsVoxels) {
  Options options = thesis();
  options.algorithm = Algorithm::svc;
  options.representation = Representation::cells;
  EXPECT_EQ(ignored_in(options, thesis_alone), "representation=cells");
}

TEST(IgnoredOptions, NameTheAlgorithmsThatReadThem) {
  Options options;
  options.algorithm = Algorithm::constrained_ssc;
  options.partition.eigenvectors = 4;

  const auto ignored = find_ignored_option(options, ours);

  ASSERT_TRUE(ignored.has_value());
  EXPECT_EQ(ignored->why, "algorithm constrained-ssc does not read it");
  EXPECT_EQ(ignored->remedy, "set algorithm to ssc or svc");
}

TEST(IgnoredOptions, OfVoxelsAreReadWhereNoImageBecomesCells) {
  Options options;
  options.voxel.neighbourhood = Neighbourhood::faces;
  EXPECT_EQ(ignored_in(options), "voxel.neighbourhood=6");
  EXPECT_EQ(find_ignored_option(options, ours)->remedy, "set representation to voxels");

  Options voxels = options;
  voxels.representation = Representation::voxels;
  EXPECT_EQ(ignored_in(voxels), "");
  Options metric = options;
  metric.voxel.viewpoint = Viewpoint::multiple;
  EXPECT_EQ(ignored_in(metric), "");
  Options svc = options;
  svc.algorithm = Algorithm::svc;
  EXPECT_EQ(ignored_in(svc), "");
}

}  // namespace
}  // namespace cleave::segmentation
