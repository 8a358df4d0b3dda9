// SPDX-License-Identifier: BSD-3-Clause
// Pictures as PNG files.
#pragma once

#include <filesystem>

#include "console/picture/picture.hpp"

namespace cleave {

// The file appears whole or not at all (replace_file). Throws std::runtime_error.
void write_png(const std::filesystem::path& file, const Picture& picture);

}  // namespace cleave
