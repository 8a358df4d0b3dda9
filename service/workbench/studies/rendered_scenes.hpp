// SPDX-License-Identifier: BSD-3-Clause
// Labelled scenes for those who bring none.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace cleave::workbench {

// So many scenes of a preset of the renderer ("medium", "crowded"), as PCD files in the folder:
// those that are there already, else rendered by cleave-render, which comes with the program.
// Their seeds are for studies alone: no default is tuned on these scenes or chosen by them. Throws
// std::runtime_error when they cannot be rendered.
[[nodiscard]] std::vector<std::filesystem::path> rendered_scenes(
    const std::filesystem::path& folder, const std::string& preset, std::uint32_t count);

}  // namespace cleave::workbench
