// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/bench/growth.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "console/table.hpp"
#include "workbench/bench/resample.hpp"

namespace cleave::workbench {

double fitted_exponent(const std::vector<double>& x, const std::vector<double>& y) {
  double n = 0;
  double sum_x = 0;
  double sum_y = 0;
  double sum_xx = 0;
  double sum_xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!(x[i] > 0 && y[i] > 0)) return 0;
    const double log_x = std::log(x[i]);
    const double log_y = std::log(y[i]);
    n += 1;
    sum_x += log_x;
    sum_y += log_y;
    sum_xx += log_x * log_x;
    sum_xy += log_x * log_y;
  }
  const double spread = n * sum_xx - sum_x * sum_x;
  return spread > 0 ? (n * sum_xy - sum_x * sum_y) / spread : 0;
}

void Growth::measure(const std::string& name, const evaluation::LabelledCloud& cloud) {
  quarter_.measure(name, quarter(cloud));
  whole_.measure(name, cloud);
  fourfold_.measure(name, quadruple(cloud));
}

std::array<const BenchResult*, 3> Growth::results() const {
  return {&quarter_.result(), &whole_.result(), &fourfold_.result()};
}

std::vector<double> Growth::points() const {
  std::vector<double> values;
  for (const BenchResult* result : results()) values.push_back(percentiles(result->points).median);
  return values;
}

std::vector<double> Growth::n_log_n() const {
  std::vector<double> values = points();
  for (double& n : values) n *= std::log(n);
  return values;
}

std::vector<double> Growth::total_ms() const {
  std::vector<double> values;
  for (const BenchResult* result : results()) {
    values.push_back(percentiles(result->ours.run_ms).median);
  }
  return values;
}

std::vector<double> Growth::stage_ms(segmentation::Stage stage) const {
  std::vector<double> values;
  for (const BenchResult* result : results()) {
    values.push_back(percentiles(result->times.of(stage)).median);
  }
  return values;
}

Json Growth::json() const {
  Json stages = Json::object();
  for (const segmentation::Stage stage : all_stages) {
    const std::vector<double> ms = stage_ms(stage);
    stages[to_string(stage)] = {{"milliseconds", ms}, {"exponent", fitted_exponent(points(), ms)}};
  }
  return {{"scenes", whole_.result().points.size()},
          {"points", points()},
          {"milliseconds", total_ms()},
          {"exponent", fitted_exponent(points(), total_ms())},
          {"n_log_n_exponent", fitted_exponent(points(), n_log_n())},
          {"stages", stages}};
}

std::string Growth::text() const {
  std::vector<Table::Column> columns = {{"stage", Align::left}};
  for (const double n : points()) {
    columns.push_back({fmt::format("{:.0f} points [ms]", n), Align::right});
  }
  columns.push_back({"exponent", Align::right});
  Table table(columns);
  const auto add = [&](const char* name, const std::vector<double>& ms) {
    std::vector<std::string> row = {name};
    for (const double value : ms) row.push_back(fmt::format("{:.2f}", value));
    row.push_back(fmt::format("{:.2f}", fitted_exponent(points(), ms)));
    table.add_row(row);
  };
  for (const segmentation::Stage stage : all_stages) add(to_string(stage), stage_ms(stage));
  add("total", total_ms());
  return table.to_string() +
         fmt::format("{} clouds, medians; n log n would have the exponent {:.2f}\n",
                     whole_.result().points.size(), fitted_exponent(points(), n_log_n()));
}

}  // namespace cleave::workbench
