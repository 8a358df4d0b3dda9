// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/bench/bench_report.hpp"

#include <spdlog/fmt/fmt.h>

#include "console/table.hpp"

namespace cleave::workbench {
namespace {

using evaluation::Quality;

double median_of(const Record& record) {
  return percentiles(record.run_ms).median;
}

Json stages_json(const StageTimes& times) {
  Json stages = Json::object();
  for (const segmentation::Stage stage : all_stages) {
    const Percentiles p = percentiles(times.of(stage));
    stages[to_string(stage)] = {{"median_ms", p.median}, {"p90_ms", p.p90}, {"p99_ms", p.p99}};
  }
  return stages;
}

Json allocations_json(const std::vector<double>& allocations) {
  if (allocations.empty()) return nullptr;
  const Spread s = spread(allocations);
  return {{"mean", s.mean}, {"max", s.max}};
}

std::vector<std::string> method_row(const std::string& name, const Record& record,
                                    double ratio_to_ours) {
  const Percentiles p = percentiles(record.run_ms);
  std::vector<std::string> row = {name, fmt::format("{:.2f}", p.median),
                                  fmt::format("{:.2f}", p.p90), fmt::format("{:.2f}", p.p99),
                                  fmt::format("{:.1f}", ratio_to_ours)};
  for (const auto measure : {&Quality::weighted_covering, &Quality::unweighted_covering}) {
    if (record.qualities.empty()) {
      row.insert(row.end(), {"-", "-"});
      continue;
    }
    const Spread s = summary(record.qualities, measure);
    row.insert(row.end(), {fmt::format("{:.4f}", s.mean), fmt::format("{:.4f}", s.min)});
  }
  return row;
}

std::string methods_table(const BenchResult& result) {
  Table table({{"method", Align::left},
               {"median [ms]", Align::right},
               {"90 % [ms]", Align::right},
               {"99 % [ms]", Align::right},
               {"times ours", Align::right},
               {"weighted covering", Align::right},
               {"min", Align::right},
               {"unweighted", Align::right},
               {"min", Align::right}});
  table.add_row(method_row("ours", result.ours, 1));
  for (const auto& [name, record] : result.peers) {
    table.add_row(method_row(name, record, median_of(record) / median_of(result.ours)));
  }
  return table.to_string();
}

std::string stages_table(const StageTimes& times) {
  Table table({{"stage", Align::left},
               {"median [ms]", Align::right},
               {"90 % [ms]", Align::right},
               {"99 % [ms]", Align::right}});
  for (const segmentation::Stage stage : all_stages) {
    const Percentiles p = percentiles(times.of(stage));
    table.add_row({to_string(stage), fmt::format("{:.2f}", p.median), fmt::format("{:.2f}", p.p90),
                   fmt::format("{:.2f}", p.p99)});
  }
  return table.to_string();
}

}  // namespace

Json json_of(const BenchResult& result) {
  Json json = {{"scenes", result.points.size()},
               {"points", json_of(percentiles(result.points))},
               {"segments", json_of(percentiles(result.segments))}};
  json.update(result.ours.json());
  json["stages"] = stages_json(result.times);
  json["allocations"] = allocations_json(result.allocations);
  if (result.peers.empty()) return json;
  Json ratio = Json::object();
  for (const auto& [name, record] : result.peers) {
    ratio[name] = median_of(record) / median_of(result.ours);
  }
  json["ratio"] = ratio;
  for (const auto& [name, record] : result.peers) json[name] = record.json();
  return json;
}

std::string text_of(const BenchResult& result) {
  std::string text = methods_table(result) + '\n' + stages_table(result.times) + '\n';
  text += fmt::format(
      "{} clouds, {} runs of ours on one thread; medians: {:.0f} points, {:.0f} segments, {:.2f} "
      "ms by the clock on the wall",
      result.points.size(), result.ours.run_ms.size(), percentiles(result.points).median,
      percentiles(result.segments).median, percentiles(result.ours.wall_ms).median);
  if (!result.allocations.empty()) {
    const Spread s = spread(result.allocations);
    text += fmt::format("; allocations a run: mean {:.1f}, max {:.0f}", s.mean, s.max);
  }
  return text + '\n';
}

std::string collapse_text(const BenchResult& result) {
  if (result.ours.qualities.empty()) return "collapses: unknown, no cloud has labels\n";
  std::string text = fmt::format(
      "collapses (weighted covering below {:.2f} where the thesis's method reaches {:.2f}): {} of "
      "{} runs\n",
      collapsed_below, thesis_reaches, result.collapses.size(), result.ours.qualities.size());
  for (const Collapse& c : result.collapses) {
    text += fmt::format("  {} at grid offset {:.3f}: {:.4f}, thesis {:.4f}\n", c.cloud,
                        c.grid_offset, c.weighted_covering, c.of_thesis);
  }
  return text;
}

Json collapse_json(const BenchResult& result) {
  if (result.ours.qualities.empty()) return nullptr;
  Json list = Json::array();
  for (const Collapse& c : result.collapses) {
    list.push_back({{"cloud", c.cloud},
                    {"grid_offset", decimal(c.grid_offset)},
                    {"weighted_covering", c.weighted_covering},
                    {"thesis", c.of_thesis}});
  }
  return list;
}

}  // namespace cleave::workbench
