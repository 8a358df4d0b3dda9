// SPDX-License-Identifier: BSD-3-Clause
// Refuses options that are out of their range, or set in vain.
#pragma once

#include "segmentation/options.hpp"

namespace cleave::segmentation {

// Throws std::invalid_argument that names the first option out of its range, and the range; or the
// first one that what was chosen does not read (ignored_options), of options that began as
// `preset`.
void check_options(const Options& options, const Options& preset);
// As Options{} or as thesis(), whichever.
void check_options(const Options& options);

}  // namespace cleave::segmentation
