// SPDX-License-Identifier: BSD-3-Clause
// Options that are set and would change nothing: each algorithm and representation reads some.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "segmentation/options.hpp"

namespace cleave::segmentation {

struct IgnoredOption {
  std::string name;    // "graph.max_step_m"
  std::string value;   // as a file or a command line has it
  std::string why;     // "algorithm svc does not read it"
  std::string remedy;  // but to leave it out: "set algorithm to ssc or constrained-ssc"
};

// The first option, in the order of visit_options, that the algorithm or the representation does
// not read although no preset gives it its value: the preset that these options began as, Options{}
// or thesis(), sets those of all algorithms, and who chooses one has not asked for the others; who
// does not know which it was names both. One that counts for some clouds only is ignored if an
// image does not read it. Each option is in its range. Deterministic; allocates.
[[nodiscard]] std::optional<IgnoredOption> find_ignored_option(const Options& options,
                                                               std::span<const Options> presets);

}  // namespace cleave::segmentation
