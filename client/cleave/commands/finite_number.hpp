// SPDX-License-Identifier: BSD-3-Clause
// Options that are numbers. CLI11's own checks compare, and so let "nan" through.
#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <string>

namespace cleave::client {

// A finite number, more than 0, or from 0 on.
inline CLI::Validator finite_number(bool or_zero = false) {
  return {[or_zero](const std::string& text) {
            double value = 0;
            const bool read = CLI::detail::lexical_cast(text, value) && std::isfinite(value);
            if (read && (value > 0 || (or_zero && value == 0))) return std::string();
            return "expected a number " + std::string(or_zero ? "from 0 on" : "more than 0") +
                   ", found '" + text + "'";
          },
          "NUMBER"};
}

}  // namespace cleave::client
