// SPDX-License-Identifier: BSD-3-Clause
// Options that are set and would change nothing: each algorithm and representation reads some.
#pragma once

#include <optional>
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
// not read although it has another value than in the preset, Options{} or thesis(), that the rest
// of these come from: a preset sets options of all algorithms, and who chooses one has not asked
// for the others. One that counts for some clouds only is ignored if an image does not read it.
// Each option is in its range. Deterministic; allocates.
[[nodiscard]] std::optional<IgnoredOption> find_ignored_option(const Options& options);

}  // namespace cleave::segmentation
