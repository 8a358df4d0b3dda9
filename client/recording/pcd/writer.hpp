// SPDX-License-Identifier: BSD-3-Clause
// A cloud back to a PCD file.
#pragma once

#include <filesystem>

#include "recording/pcd/cloud.hpp"

namespace cleave::recording {

// Writes PCD v0.7, `binary` if the cloud's header says that, else `binary_compressed`: text would
// round. The same cloud gives the same bytes.
// The file appears whole or not at all (replace_file). Throws std::runtime_error.
void write_pcd(const std::filesystem::path& file, const PcdCloud& cloud);

}  // namespace cleave::recording
