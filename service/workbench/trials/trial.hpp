// SPDX-License-Identifier: BSD-3-Clause
// Methods tried on labelled scenes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "recording/units/unit.hpp"
#include "workbench/evaluation/boundary.hpp"
#include "workbench/evaluation/quality.hpp"
#include "workbench/trials/methods.hpp"

namespace cleave::workbench {

struct TrialPlan {
  std::vector<Method> methods;
  std::uint32_t grid_offsets = 1;            // shifts of the grid, evenly over one voxel
  std::uint32_t jobs = 1;                    // scenes at a time
  std::filesystem::path pictures{};          // folder for a sheet a scene; empty = none
  std::optional<recording::Unit> unit = {};  // of the files; see load_cloud()
};

// One segmentation of one scene.
struct Run {
  float grid_offset = 0;
  double milliseconds = 0;  // that its thread had a core for
  evaluation::Quality quality;
  evaluation::BoundaryScore boundary;
};

struct Scene {
  std::filesystem::path file;
  std::string problem;  // why it could not be tried; empty = it was
  std::size_t points = 0;
  std::uint32_t true_segments = 0;
  std::vector<std::vector<Run>> runs;  // one list a method, in the plan's order

  [[nodiscard]] bool tried() const { return problem.empty(); }
};

// Tells how many of all runs are done; called from one thread at a time, never at the same time.
using TrialProgress = std::function<void(std::size_t done, std::size_t all)>;

// A scene a file, in their order: for any number of jobs the same, but for the time. A file that
// cannot be read or has no labels is a scene with a problem. Throws std::runtime_error when a
// picture cannot be written or PCL's methods cannot be loaded.
[[nodiscard]] std::vector<Scene> try_scenes(const TrialPlan& plan,
                                            const std::vector<std::filesystem::path>& files,
                                            const TrialProgress& progress);

}  // namespace cleave::workbench
