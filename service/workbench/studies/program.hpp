// SPDX-License-Identifier: BSD-3-Clause
// Other programs, run and waited for.
#pragma once

#include <string>
#include <vector>

namespace cleave::workbench {

enum class ProgramEnd { done, failed, not_found };

// The first word is the program, found as a shell finds it; its output goes where ours goes.
// Throws std::runtime_error when no process can be started for another reason.
[[nodiscard]] ProgramEnd run_program(const std::vector<std::string>& words);

}  // namespace cleave::workbench
