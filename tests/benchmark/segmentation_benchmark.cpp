// SPDX-License-Identifier: BSD-3-Clause
// What each stage of the segmentation costs, and the whole, on a rendered scene of 1/4 to 4 times
// the usual points.
#include <benchmark/benchmark.h>

#include <map>
#include <string>

#include "segmentation/segmenter.hpp"
#include "sensor/renderer/scene/scene_loop.hpp"
#include "workbench/bench/stage_times.hpp"

namespace {

using namespace cleave;
using segmentation::Representation;

struct Cloud {
  std::uint32_t width, height;
  std::vector<float> xyz;
};

// Rendered once for each scale.
const Cloud& crowded_scene(double scale) {
  static std::map<double, Cloud> clouds;
  const auto known = clouds.find(scale);
  if (known != clouds.end()) return known->second;
  const render::CameraModel camera = render::scaled({}, scale);
  render::SceneLoop loop(render::parse_scene("crowded?seed=1"), camera);
  return clouds
      .emplace(scale, Cloud{camera.width, camera.height,
                            render::to_points(loop.frame(0), camera.intrinsics)})
      .first->second;
}

// The scale is range(0) halves. `stage_ms` says what of a run counts.
template <class StageMs>
void run(benchmark::State& state, Representation representation, const StageMs& stage_ms) {
  const Cloud& cloud = crowded_scene(static_cast<double>(state.range(0)) / 2);
  const segmentation::CloudView view{cloud.xyz.data(), 3, cloud.width, cloud.height};
  segmentation::Options options;
  options.representation = representation;
  segmentation::Segmenter segmenter(options);
  std::vector<std::uint16_t> labels(view.size());
  segmentation::Segmentation result;
  workbench::StageClock clock;
  (void)segmenter.segment(view, labels, result);  // sizes the memory
  for ([[maybe_unused]] auto _ : state) {
    clock.start();
    (void)segmenter.segment(view, labels, result, &clock);
    state.SetIterationTime(stage_ms(clock) / 1e3);
  }
  state.counters["points"] = static_cast<double>(view.size());
  state.SetComplexityN(static_cast<benchmark::IterationCount>(view.size()));
}

template <class StageMs>
void add(const std::string& name, Representation representation, const StageMs& stage_ms) {
  benchmark::RegisterBenchmark(
      name.c_str(), [=](benchmark::State& state) { run(state, representation, stage_ms); })
      ->ArgName("half_scale")
      ->Arg(1)
      ->Arg(2)
      ->Arg(4)
      ->Unit(benchmark::kMillisecond)
      ->UseManualTime()
      ->MinTime(0.2)
      ->Complexity(benchmark::oNLogN);
}

}  // namespace

int main(int argc, char** argv) {
  for (const auto& [name, representation] :
       {std::pair{std::string("cells/"), Representation::cells},
        std::pair{std::string("voxels/"), Representation::voxels}}) {
    add(name + "whole", representation,
        [](const workbench::StageClock& clock) { return clock.total_ms(); });
    for (const segmentation::Stage stage : workbench::all_stages) {
      add(name + to_string(stage), representation,
          [stage](const workbench::StageClock& clock) { return clock.stage_ms(stage); });
    }
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
