// SPDX-License-Identifier: BSD-3-Clause
// Starting the program anew in place.
#pragma once

namespace cleave {

// Says so in the log, and replaces this process by a fresh one of the same program and arguments:
// same process id, nothing else kept. Returns never; throws std::runtime_error if the system
// refuses.
[[noreturn]] void restart_in_place(char** arguments);

}  // namespace cleave
