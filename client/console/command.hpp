// SPDX-License-Identifier: BSD-3-Clause
// What all subcommands share: each adds itself to the command line, and leaves behind what is to be
// run once that has been understood.
#pragma once

#include <functional>
#include <stdexcept>

#include "libcleave/process/exit_codes.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11 has named it
class App;
}

namespace cleave {

// The subcommand that was chosen; returns the exit code, or throws: UsageError for 2, else 1.
using Action = std::function<int()>;

class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace cleave
