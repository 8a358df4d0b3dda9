// SPDX-License-Identifier: BSD-3-Clause
// How every program ends.
#pragma once

namespace cleave {

inline constexpr int exit_done = 0;
inline constexpr int exit_failed = 1;       // at run time
inline constexpr int exit_wrong_usage = 2;  // of the command line or of a configuration

}  // namespace cleave
