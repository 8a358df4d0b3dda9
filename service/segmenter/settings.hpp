// SPDX-License-Identifier: BSD-3-Clause
// From the configuration file, the arguments and the environment to what the daemon needs.
#pragma once

#include "segmenter/command_line.hpp"
#include "segmenter/daemon.hpp"

namespace cleave::service {

// Arguments go before the file, and the environment's CLEAVE_DOMAIN before both.
// Throws config::ConfigurationError for the file, std::invalid_argument for the rest.
[[nodiscard]] DaemonSettings read_settings(const CommandLine& line);

}  // namespace cleave::service
