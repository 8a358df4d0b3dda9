// SPDX-License-Identifier: BSD-3-Clause
// Time that this thread has had a core for.
#pragma once

#include <ctime>

namespace cleave::workbench {

// Milliseconds since some moment. On an idle machine it goes as fast as the time of day while the
// thread computes; on a busy one it stands still while others have the core, so that figures taken
// there hold elsewhere.
[[nodiscard]] inline double thread_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

}  // namespace cleave::workbench
