// SPDX-License-Identifier: BSD-3-Clause
// Does someone look at this output, and how wide is their window?
#pragma once

#include <cstddef>

namespace cleave {

[[nodiscard]] bool is_terminal(int file_descriptor);

// Columns of the terminal; 80 where that is not known.
[[nodiscard]] std::size_t terminal_columns(int file_descriptor);

// Columns for lines that are rewritten in place: 0 where this is not a terminal.
[[nodiscard]] std::size_t live_columns(int file_descriptor);

}  // namespace cleave
