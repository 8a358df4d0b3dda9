// SPDX-License-Identifier: BSD-3-Clause
// What the commands that try methods on labelled scenes have in common.
#pragma once

#include <filesystem>
#include <vector>

#include "workbench/trials/trial.hpp"

namespace cleave::workbench {

// try_scenes with a progress bar on a terminal, and a warning for each scene that had to be
// skipped. Throws std::runtime_error where all had to be.
[[nodiscard]] std::vector<Scene> try_and_warn(const TrialPlan& plan,
                                              const std::vector<std::filesystem::path>& files);

}  // namespace cleave::workbench
