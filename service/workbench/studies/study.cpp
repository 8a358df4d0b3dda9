// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/studies/study.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <numbers>

#include "workbench/cloud/option_setter.hpp"

namespace cleave::workbench {
namespace {

std::vector<double> range(double first, double last, double step) {
  std::vector<double> values;
  for (int i = 0; first + i * step <= last; ++i) values.push_back(first + i * step);
  return values;
}

std::vector<Study> all_studies() {
  return {
      {.name = "cannot-link-threshold",
       .figure = "5.9",
       .title = "SSC: cannot-link threshold",
       .x_label = "cannot-link threshold [degrees]",
       .option = "graph.cannot_link_rad",
       .unit = std::numbers::pi / 180,
       .x = range(5, 90, 5),
       .settings = {}},
      {.name = "eigenvectors-single",
       .figure = "5.11",
       .title = "SSC: eigenvectors of a single decomposition",
       .x_label = "eigenvectors",
       .option = "partition.eigenvectors",
       .x = range(1, 30, 1),
       .settings = {"partition.decomposition=single"}},
      {.name = "eigenvectors-recursive",
       .figure = "5.12",
       .title = "SSC: eigenvectors of each of the recursive decompositions",
       .x_label = "eigenvectors",
       .option = "partition.eigenvectors",
       .x = range(1, 20, 1),
       .settings = {"partition.decomposition=recursive"}},
      {.name = "cannot-link-weight",
       .figure = "5.13",
       .title = "Constrained SSC: weight of cannot-link edges",
       .x_label = "cannot-link weight",
       .option = "partition.cannot_link_weight",
       .x = {0, 0.25, 0.5, 0.75, 1, 1.5, 2, 3, 4, 5, 6, 7, 8, 9, 10},
       .settings = {"algorithm=constrained-ssc"}},
  };
}

}  // namespace

const std::vector<Study>& studies() {
  static const std::vector<Study> all = all_studies();
  return all;
}

const Study* find_study(std::string_view name) {
  const auto found = std::ranges::find(studies(), name, &Study::name);
  return found == studies().end() ? nullptr : &*found;
}

std::vector<Method> methods_of(const Study& study, const std::vector<std::string>& settings) {
  segmentation::Options options = segmentation::thesis();
  for (const std::string& setting : study.settings) set_option(options, setting);
  for (const std::string& setting : settings) set_option(options, setting);
  std::vector<Method> methods;
  for (const double x : study.x) {
    set_option(options, fmt::format("{}={}", study.option, x * study.unit));
    methods.push_back(our_method(fmt::format("{}", x), options, segmentation::thesis()));
  }
  return methods;
}

}  // namespace cleave::workbench
