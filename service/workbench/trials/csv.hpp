// SPDX-License-Identifier: BSD-3-Clause
// Tables for spreadsheets.
#pragma once

#include <string>
#include <string_view>

#include "workbench/trials/report.hpp"

namespace cleave::workbench {

// The text as a field: in quotes where it has to be (RFC 4180).
[[nodiscard]] std::string csv_field(std::string_view text);

// A line of titles and a line a run: index,file,algorithm,grid_offset,points,true_segments,
// found_segments, a column a measure, milliseconds. Scenes that could not be tried are left out.
[[nodiscard]] std::string csv_of(const TrialResult& result);

}  // namespace cleave::workbench
