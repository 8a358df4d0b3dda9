// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/trials/measures.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace cleave::workbench {
namespace {

constexpr std::array all_measures = {
    Measure{"weighted_covering", [](const Run& run) { return run.quality.weighted_covering; }},
    Measure{"unweighted_covering", [](const Run& run) { return run.quality.unweighted_covering; }},
    Measure{"under_segmentation",
            [](const Run& run) { return static_cast<double>(run.quality.under); }},
    Measure{"over_segmentation",
            [](const Run& run) { return static_cast<double>(run.quality.over); }},
    Measure{"boundary_f", [](const Run& run) { return run.boundary.f; }},
    Measure{"boundary_precision", [](const Run& run) { return run.boundary.precision; }},
    Measure{"boundary_recall", [](const Run& run) { return run.boundary.recall; }},
    Measure{"object_f", [](const Run& run) { return run.quality.object_f; }},
    Measure{"object_precision", [](const Run& run) { return run.quality.object_precision; }},
    Measure{"object_recall", [](const Run& run) { return run.quality.object_recall; }},
};

}  // namespace

std::span<const Measure> measures() {
  return all_measures;
}

const Measure& measure(std::string_view key) {
  const auto found = std::ranges::find(all_measures, key, &Measure::key);
  if (found == all_measures.end()) throw std::out_of_range("no measure " + std::string(key));
  return *found;
}

Sample::Sample(const std::vector<Scene>& scenes, std::size_t method, const Group& group) {
  for (std::size_t i = group.first; i <= group.last && i < scenes.size(); ++i) {
    if (!scenes[i].tried()) continue;
    ++scenes_;
    for (const Run& run : scenes[i].runs[method]) runs_.push_back(&run);
  }
}

Spread Sample::spread_of(const Measure& measure) const {
  std::vector<double> values;
  values.reserve(runs_.size());
  for (const Run* run : runs_) values.push_back(measure.of(*run));
  return spread(values);
}

Percentiles Sample::milliseconds() const {
  std::vector<double> values;
  values.reserve(runs_.size());
  for (const Run* run : runs_) values.push_back(run->milliseconds);
  return percentiles(std::move(values));
}

}  // namespace cleave::workbench
