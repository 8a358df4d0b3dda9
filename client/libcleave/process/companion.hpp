// SPDX-License-Identifier: BSD-3-Clause
// Files that come with the program that runs: programs of ours that it starts, plug-ins that it
// loads.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace cleave {

// `file`, a name or a relative path, beside the program (a build folder, or a copy of it) or in
// ../lib/cleave (an installation), the first that is there. The environment and the working
// directory have no say.
[[nodiscard]] std::optional<std::filesystem::path> find_companion(
    const std::filesystem::path& file);

// That it is in none of these places, each named, and what to do about it.
[[nodiscard]] std::string missing_companion(const std::filesystem::path& file,
                                            std::string_view remedy);

// Throws std::runtime_error with that where it is not found.
[[nodiscard]] std::filesystem::path companion(const std::filesystem::path& file,
                                              std::string_view remedy);

}  // namespace cleave
