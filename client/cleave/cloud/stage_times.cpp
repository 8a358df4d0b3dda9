#include "cleave/cloud/stage_times.hpp"

#include <spdlog/fmt/fmt.h>

#include "cleave/console/table.hpp"

namespace cleave::client {

void StageTimes::stage_ended(segmentation::Stage stage) {
  const auto now = std::chrono::steady_clock::now();
  const double elapsed_ms = std::chrono::duration<double, std::milli>(now - stage_began_).count();
  stages_ms_[stage].push_back(elapsed_ms);
  cloud_ms_ += elapsed_ms;
  stage_began_ = now;
}

void StageTimes::end_cloud() {
  totals_ms_.push_back(cloud_ms_);
  cloud_ms_ = 0;
}

std::string StageTimes::table() const {
  Table table({{"stage", Align::left},
               {"median [ms]", Align::right},
               {"90 % [ms]", Align::right},
               {"99 % [ms]", Align::right}});
  const auto add = [&](const char* name, const std::vector<double>& times_ms) {
    const Percentiles p = percentiles(times_ms);
    table.add_row({name, fmt::format("{:.2f}", p.median), fmt::format("{:.2f}", p.p90),
                   fmt::format("{:.2f}", p.p99)});
  };
  for (const auto& [stage, times_ms] : stages_ms_) add(to_string(stage), times_ms);
  add("total", totals_ms_);
  return table.to_string();
}

Json StageTimes::json() const {
  Json stages = Json::object();
  for (const auto& [stage, times_ms] : stages_ms_) {
    stages[to_string(stage)] = json_of(percentiles(times_ms));
  }
  return {{"total_ms", json_of(percentiles(totals_ms_))}, {"stages_ms", stages}};
}

}  // namespace cleave::client
