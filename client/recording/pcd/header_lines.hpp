// SPDX-License-Identifier: BSD-3-Clause
// The header of a PCD file as text: which lines there are, not yet what they mean.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "recording/pcd/input.hpp"

namespace cleave::recording {

// The words behind each keyword that the header has; COLUMNS, as PCD 0.5 calls them, are FIELDS.
using HeaderLines = std::map<std::string, std::vector<std::string>, std::less<>>;

// Reads the lines up to DATA, in any order, and leaves `input` at the first byte behind them.
// Comments and empty lines are passed over. Throws PcdError: for a line that begins with none of
// PCD's words, for a second line of a kind, and where there is no DATA in the first 64 kB.
[[nodiscard]] HeaderLines read_header_lines(PcdInput& input);

}  // namespace cleave::recording
