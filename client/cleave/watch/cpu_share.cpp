// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/watch/cpu_share.hpp"

namespace cleave::client {

void CpuShare::add(const NodeReport& report, std::chrono::steady_clock::time_point now) {
  const Moment moment{report.process_id, report.frames_in, report.cpu_time_s, now};
  if (!first_ || first_->process_id != moment.process_id || moment.frames == 0) {
    first_ = last_ = moment;
  } else if (moment.frames != last_->frames) {
    last_ = moment;
  }
}

double CpuShare::share() const {
  if (!first_ || last_->time <= first_->time) return 0;
  return (last_->cpu_time_s - first_->cpu_time_s) /
         std::chrono::duration<double>(last_->time - first_->time).count();
}

}  // namespace cleave::client
