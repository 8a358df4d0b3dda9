// SPDX-License-Identifier: BSD-3-Clause
// The parameter studies of section 5.3 of the thesis: one option varies, all else is as in the
// thesis.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "workbench/trials/methods.hpp"

namespace cleave::workbench {

struct Study {
  std::string name;
  std::string figure;   // of the thesis: "5.9"
  std::string title;    // of the plot
  std::string x_label;  // what varies, as a reader says it
  std::string option;   // that varies
  double unit = 1;      // an option's value is x times this: radians from degrees
  std::vector<double> x;
  std::vector<std::string> settings;  // KEY=VALUE on top of the thesis's values
};

[[nodiscard]] const std::vector<Study>& studies();
// nullptr where there is none of this name.
[[nodiscard]] const Study* find_study(std::string_view name);

// A method an x, in their order; `settings` go on top of the study's own. Throws OptionError.
[[nodiscard]] std::vector<Method> methods_of(const Study& study,
                                             const std::vector<std::string>& settings);

}  // namespace cleave::workbench
