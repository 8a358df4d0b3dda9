// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/bench/stage_times.hpp"

#include <numeric>

namespace cleave::workbench {

void StageClock::stage_ended(segmentation::Stage stage) {
  const double now_ms = thread_ms();
  stages_ms_[static_cast<std::size_t>(stage)] = now_ms - stage_began_ms_;
  stage_began_ms_ = now_ms;
}

double StageClock::total_ms() const {
  return std::accumulate(stages_ms_.begin(), stages_ms_.end(), 0.0);
}

void StageTimes::add(const StageClock& run) {
  for (const segmentation::Stage stage : all_stages) {
    stages[static_cast<std::size_t>(stage)].push_back(run.stage_ms(stage));
  }
  total.push_back(run.total_ms());
}

}  // namespace cleave::workbench
