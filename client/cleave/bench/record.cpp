#include "cleave/bench/record.hpp"

#include <algorithm>

namespace cleave::client {
namespace {

using evaluation::Quality;

Json json_of(const std::vector<Quality>& qualities, double Quality::*measure) {
  if (qualities.empty()) return nullptr;
  const MeanAndMin s = summary(qualities, measure);
  return {{"mean", s.mean}, {"min", s.min}};
}

}  // namespace

MeanAndMin summary(const std::vector<Quality>& qualities, double Quality::*measure) {
  double sum = 0;
  double min = qualities.front().*measure;
  for (const Quality& quality : qualities) {
    sum += quality.*measure;
    min = std::min(min, quality.*measure);
  }
  return {sum / static_cast<double>(qualities.size()), min};
}

Json Record::json() const {
  return {{"milliseconds", client::json_of(percentiles(run_ms))},
          {"wall_milliseconds", client::json_of(percentiles(wall_ms))},
          {"weighted_covering", json_of(qualities, &Quality::weighted_covering)},
          {"unweighted_covering", json_of(qualities, &Quality::unweighted_covering)}};
}

}  // namespace cleave::client
