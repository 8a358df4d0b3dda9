// SPDX-License-Identifier: BSD-3-Clause
// Trials for people, for programs and for spreadsheets.
#pragma once

#include <string>
#include <vector>

#include "console/json.hpp"
#include "workbench/trials/groups.hpp"
#include "workbench/trials/trial.hpp"

namespace cleave::workbench {

struct TrialResult {
  std::vector<std::string> methods;  // names, in the order of the scenes' runs
  std::vector<Scene> scenes;
  std::vector<Group> groups;

  [[nodiscard]] std::size_t skipped() const;
};

// A line a scene (means over its grid offsets), then a table of all methods over all scenes, and
// one over each group. With several methods a scene's line holds the unweighted covering of each.
[[nodiscard]] std::string text_of(const TrialResult& result);

// {"algorithm", "scenes", "skipped", "runs", "weighted_covering": {mean, min, max}, .. (a key a
// measure), "milliseconds": {median, p90, p99}, "groups": [{"group": "0-15", ..}, ..]} of the first
// method, "algorithms": {name: the same, ..} of all, and "per_scene": [{"index", "file", "points",
// "true_segments", "algorithms": {name: {..}}}, ..].
[[nodiscard]] Json json_of(const TrialResult& result);

}  // namespace cleave::workbench
