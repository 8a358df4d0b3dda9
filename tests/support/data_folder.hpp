// SPDX-License-Identifier: BSD-3-Clause
// Where recorded data lies.
#pragma once

#include <filesystem>
#include <optional>

namespace cleave::tests {

// A folder below CLEAVE_DATA: the environment variable, else what CMake was told, else
// ../shared/data beside the project. Nothing if it does not exist.
[[nodiscard]] std::optional<std::filesystem::path> find_data(const std::filesystem::path& folder);

}  // namespace cleave::tests
