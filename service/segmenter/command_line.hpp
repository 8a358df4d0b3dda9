// SPDX-License-Identifier: BSD-3-Clause
// What the user types.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

namespace cleave::service {

struct CommandLine {
  std::string config_file;               // empty: the installation's
  std::optional<std::uint32_t> workers;  // 1 to config::max_workers
  std::optional<std::string> sensor;
  bool lossless = false;
  bool no_shared_memory = false;
};

// The arguments, or the code to exit with: 0 after --help, 2 for wrong usage, which is said on
// stderr.
[[nodiscard]] std::variant<CommandLine, int> parse_command_line(int count,
                                                                const char* const* arguments);

}  // namespace cleave::service
