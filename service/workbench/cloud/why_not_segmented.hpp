// SPDX-License-Identifier: BSD-3-Clause
// Why a cloud has no segments, for people.
#pragma once

#include <string_view>

#include "segmentation/segmentation.hpp"

namespace cleave::workbench {

// What is wrong with the cloud, and what to do; empty for one that was segmented.
[[nodiscard]] std::string_view why_not_segmented(segmentation::Outcome outcome);

}  // namespace cleave::workbench
