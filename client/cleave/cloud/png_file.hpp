// Pictures as PNG files.
#pragma once

#include <filesystem>

#include "cleave/cloud/picture.hpp"

namespace cleave::client {

// The file appears whole or not at all (replace_file). Throws std::runtime_error.
void write_png(const std::filesystem::path& file, const Picture& picture);

}  // namespace cleave::client
