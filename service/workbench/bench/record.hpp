// SPDX-License-Identifier: BSD-3-Clause
// What the runs of one method showed.
#pragma once

#include <vector>

#include "console/json.hpp"
#include "console/percentiles.hpp"
#include "workbench/evaluation/quality.hpp"

namespace cleave::workbench {

struct Record {
  std::vector<double> run_ms;                  // one a timed run: time of its thread
  std::vector<double> wall_ms;                 // the same runs by the clock on the wall
  std::vector<evaluation::Quality> qualities;  // one a result whose cloud has labels

  // {"milliseconds": {median, p90, p99}, "wall_milliseconds": .., "weighted_covering": {mean, min},
  // "unweighted_covering":
  // ..}; the coverings are null where no cloud has labels.
  [[nodiscard]] Json json() const;
};

// Of one measure over all qualities.
[[nodiscard]] Spread summary(const std::vector<evaluation::Quality>& qualities,
                             double evaluation::Quality::*measure);

}  // namespace cleave::workbench
