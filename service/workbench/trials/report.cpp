// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/trials/report.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "console/table.hpp"
#include "workbench/trials/measures.hpp"

namespace cleave::workbench {
namespace {

Json json_of_sample(const Sample& sample) {
  Json json = {{"scenes", sample.scenes()}, {"runs", sample.runs()}};
  for (const Measure& measure : measures()) {
    if (sample.runs() == 0) {
      json[measure.key] = nullptr;
      continue;
    }
    const Spread s = sample.spread_of(measure);
    json[measure.key] = {{"mean", s.mean}, {"min", s.min}, {"max", s.max}};
  }
  json["milliseconds"] = sample.runs() == 0 ? Json(nullptr) : json_of(sample.milliseconds());
  return json;
}

Json json_of_method(const TrialResult& result, std::size_t method) {
  Json json = {{"algorithm", result.methods[method]}};
  json.update(json_of_sample(sample_of(result.scenes, method)));
  if (result.groups.empty()) return json;
  json["groups"] = Json::array();
  for (const Group& group : result.groups) {
    Json of_group = {{"group", group.name()}};
    of_group.update(json_of_sample({result.scenes, method, group}));
    json["groups"].push_back(std::move(of_group));
  }
  return json;
}

Json json_of_scene(const TrialResult& result, std::size_t index) {
  const Scene& scene = result.scenes[index];
  Json json = {{"index", index}, {"file", scene.file.string()}};
  if (!scene.tried()) {
    json["problem"] = scene.problem;
    return json;
  }
  json["points"] = scene.points;
  json["true_segments"] = scene.true_segments;
  for (std::size_t m = 0; m < result.methods.size(); ++m) {
    const Sample sample(result.scenes, m, {index, index});
    Json means = Json::object();
    for (const Measure& measure : measures()) means[measure.key] = sample.spread_of(measure).mean;
    means["milliseconds"] = sample.milliseconds().median;
    json["algorithms"][result.methods[m]] = std::move(means);
  }
  return json;
}

std::string covering(double value) {
  return fmt::format("{:.4f}", value);
}

std::string count(double value) {
  return fmt::format("{:.2f}", value);
}

// One method: what there is to know of each scene.
std::string scenes_table(const TrialResult& result) {
  Table table({{"#", Align::right},
               {"scene", Align::left},
               {"segments", Align::right},
               {"weighted covering", Align::right},
               {"unweighted", Align::right},
               {"under", Align::right},
               {"over", Align::right},
               {"boundary F", Align::right},
               {"object F", Align::right},
               {"median [ms]", Align::right}});
  for (std::size_t i = 0; i < result.scenes.size(); ++i) {
    const Scene& scene = result.scenes[i];
    if (!scene.tried()) continue;
    const Sample sample(result.scenes, 0, {i, i});
    table.add_row(
        {fmt::format("{}", i), scene.file.filename().string(),
         fmt::format("{}", scene.true_segments), covering(sample.mean_of("weighted_covering")),
         covering(sample.mean_of("unweighted_covering")),
         count(sample.mean_of("under_segmentation")), count(sample.mean_of("over_segmentation")),
         covering(sample.mean_of("boundary_f")), covering(sample.mean_of("object_f")),
         fmt::format("{:.1f}", sample.milliseconds().median)});
  }
  return table.to_string();
}

// Several: the measure that tells them apart best.
std::string comparison_of_scenes(const TrialResult& result) {
  std::vector<Table::Column> columns = {
      {"#", Align::right}, {"scene", Align::left}, {"segments", Align::right}};
  for (const std::string& name : result.methods) columns.push_back({name, Align::right});
  Table table(std::move(columns));
  for (std::size_t i = 0; i < result.scenes.size(); ++i) {
    const Scene& scene = result.scenes[i];
    if (!scene.tried()) continue;
    std::vector<std::string> row = {fmt::format("{}", i), scene.file.filename().string(),
                                    fmt::format("{}", scene.true_segments)};
    for (std::size_t m = 0; m < result.methods.size(); ++m) {
      row.push_back(covering(Sample(result.scenes, m, {i, i}).mean_of("unweighted_covering")));
    }
    table.add_row(std::move(row));
  }
  return "Unweighted covering:\n" + table.to_string();
}

std::string methods_table(const TrialResult& result, const Group& group) {
  Table table({{"algorithm", Align::left},
               {"weighted covering", Align::right},
               {"min", Align::right},
               {"unweighted", Align::right},
               {"min", Align::right},
               {"under", Align::right},
               {"over", Align::right},
               {"boundary F", Align::right},
               {"object P", Align::right},
               {"object R", Align::right},
               {"object F", Align::right},
               {"median [ms]", Align::right}});
  for (std::size_t m = 0; m < result.methods.size(); ++m) {
    const Sample sample(result.scenes, m, group);
    const Spread weighted = sample.spread_of(measure("weighted_covering"));
    const Spread unweighted = sample.spread_of(measure("unweighted_covering"));
    table.add_row(
        {result.methods[m], covering(weighted.mean), covering(weighted.min),
         covering(unweighted.mean), covering(unweighted.min),
         count(sample.mean_of("under_segmentation")), count(sample.mean_of("over_segmentation")),
         covering(sample.mean_of("boundary_f")), covering(sample.mean_of("object_precision")),
         covering(sample.mean_of("object_recall")), covering(sample.mean_of("object_f")),
         fmt::format("{:.1f}", sample.milliseconds().median)});
  }
  return table.to_string();
}

}  // namespace

std::size_t TrialResult::skipped() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(scenes, [](const Scene& scene) { return !scene.tried(); }));
}

std::string text_of(const TrialResult& result) {
  std::string text =
      result.methods.size() == 1 ? scenes_table(result) : comparison_of_scenes(result);
  const std::size_t tried = result.scenes.size() - result.skipped();
  text += fmt::format("\n{} scene{}", tried, tried == 1 ? "" : "s");
  if (result.skipped() > 0) text += fmt::format(", {} skipped", result.skipped());
  text += ":\n" + methods_table(result, {0, result.scenes.size() - 1});
  for (const Group& group : result.groups) {
    const std::size_t scenes = Sample(result.scenes, 0, group).scenes();
    text += fmt::format("\nScenes {}, {} of them:\n", group.name(), scenes);
    text += scenes > 0 ? methods_table(result, group) : "none could be read\n";
  }
  return text;
}

Json json_of(const TrialResult& result) {
  Json json = json_of_method(result, 0);
  json["skipped"] = result.skipped();
  json["algorithms"] = Json::object();
  for (std::size_t m = 0; m < result.methods.size(); ++m) {
    json["algorithms"][result.methods[m]] = json_of_method(result, m);
  }
  json["per_scene"] = Json::array();
  for (std::size_t i = 0; i < result.scenes.size(); ++i) {
    json["per_scene"].push_back(json_of_scene(result, i));
  }
  return json;
}

}  // namespace cleave::workbench
