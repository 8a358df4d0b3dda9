// SPDX-License-Identifier: BSD-3-Clause
// What cleave-grabber is told by its command line and its configuration file together.
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "config/grabber_config.hpp"

namespace cleave::sensor {

struct Settings {
  config::GrabberConfig config;             // with the command line's options put in
  std::optional<std::uint64_t> max_frames;  // end after so many
};

// The settings, or the exit code with which the program ends now (0 after --help, 2 for a wrong
// usage, said on stderr). Throws config::ConfigurationError.
[[nodiscard]] std::variant<Settings, int> read_command_line(int argc, char** argv);

}  // namespace cleave::sensor
