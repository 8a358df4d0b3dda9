// SPDX-License-Identifier: BSD-3-Clause
// The configuration of an installation, for programs that are started without --config.
#pragma once

#include <filesystem>
#include <string_view>

namespace cleave {

// `name`, e.g. "grabber.yaml", in ../etc/cleave as seen from the program (an installation, wherever
// it was moved to), else in /etc/cleave. The environment and the working directory have no say.
// Throws std::invalid_argument, which names both places, where it is in neither.
[[nodiscard]] std::filesystem::path settings_file(std::string_view name);

}  // namespace cleave
