// SPDX-License-Identifier: BSD-3-Clause
// --unit, of commands that read points.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "recording/units/unit.hpp"

namespace cleave {

struct UnitArgument {
  std::string name;  // empty = metres, and millimetres are refused

  [[nodiscard]] std::optional<recording::Unit> unit() const { return recording::unit_named(name); }
};

inline void add_unit_option(CLI::App& command, UnitArgument& argument) {
  const std::vector<std::string> names(recording::unit_names.begin(), recording::unit_names.end());
  command
      .add_option("--unit", argument.name,
                  "unit of the points, which are scaled to metres; without\n"
                  "it they are metres, and what is seen to be in millimetres\n"
                  "is refused")
      ->check(CLI::IsMember(names));
}

}  // namespace cleave
