// SPDX-License-Identifier: BSD-3-Clause
// The figures of a bench, for people and for programs.
#pragma once

#include <string>

#include "workbench/bench/bench.hpp"

namespace cleave::workbench {

// {"scenes", "points", "segments", "milliseconds": {median, p90, p99}, "wall_milliseconds": ..,
// "weighted_covering": {mean, min}, "unweighted_covering": .., "stages": {"voxelise": {median_ms,
// p90_ms, p99_ms}, ..}, "allocations": {mean, max}, "ratio": {"pcl_ssc": .., ..}, "pcl_ssc":
// {"milliseconds", ..}, ..}. A ratio is the peer's median over ours.
[[nodiscard]] Json json_of(const BenchResult& result);

// A table of methods and one of our stages.
[[nodiscard]] std::string text_of(const BenchResult& result);

// A line that counts the collapses, and one for each.
[[nodiscard]] std::string collapse_text(const BenchResult& result);
// [{"cloud", "grid_offset", "weighted_covering", "thesis"}, ..]; null where no cloud has labels.
[[nodiscard]] Json collapse_json(const BenchResult& result);

}  // namespace cleave::workbench
