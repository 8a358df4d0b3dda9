// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/commands/trial_run.hpp"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <stdexcept>

#include "console/progress_bar.hpp"
#include "console/terminal.hpp"

namespace cleave::workbench {

std::vector<Scene> try_and_warn(const TrialPlan& plan,
                                const std::vector<std::filesystem::path>& files) {
  std::vector<Scene> scenes;
  {
    ProgressBar progress(std::cerr, live_columns(STDERR_FILENO));
    scenes = try_scenes(plan, files,
                        [&](std::size_t done, std::size_t all) { progress.show(done, all); });
  }
  for (const Scene& scene : scenes) {
    if (!scene.tried()) spdlog::warn("skipped: {}", scene.problem);
  }
  if (std::ranges::none_of(scenes, &Scene::tried)) {
    throw std::runtime_error("no scene could be evaluated; the warnings above say why");
  }
  return scenes;
}

}  // namespace cleave::workbench
