// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/bench/record.hpp"

#include <vector>

namespace cleave::workbench {
namespace {

using evaluation::Quality;

Json json_of(const std::vector<Quality>& qualities, double Quality::*measure) {
  if (qualities.empty()) return nullptr;
  const Spread s = summary(qualities, measure);
  return {{"mean", s.mean}, {"min", s.min}};
}

}  // namespace

Spread summary(const std::vector<Quality>& qualities, double Quality::*measure) {
  std::vector<double> values;
  values.reserve(qualities.size());
  for (const Quality& quality : qualities) values.push_back(quality.*measure);
  return spread(values);
}

Json Record::json() const {
  return {{"milliseconds", json_of(percentiles(run_ms))},
          {"wall_milliseconds", json_of(percentiles(wall_ms))},
          {"weighted_covering", json_of(qualities, &Quality::weighted_covering)},
          {"unweighted_covering", json_of(qualities, &Quality::unweighted_covering)}};
}

}  // namespace cleave::workbench
