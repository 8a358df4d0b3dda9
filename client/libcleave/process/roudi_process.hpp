// SPDX-License-Identifier: BSD-3-Clause
// RouDi as a process of this machine.
#pragma once

#include <sys/types.h>

namespace cleave {

inline constexpr char roudi_program[] = "iox-roudi";

// Whether that process runs RouDi. False for one that is not seen from here.
[[nodiscard]] bool is_roudi(pid_t process);

// The first that runs; 0 = none is seen.
[[nodiscard]] pid_t find_roudi();

}  // namespace cleave
