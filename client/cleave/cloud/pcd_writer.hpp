// A cloud back to a PCD file.
#pragma once

#include <filesystem>

#include "cleave/cloud/pcd_cloud.hpp"

namespace cleave::client {

// Writes PCD v0.7, `binary` if the cloud was read from that, else `binary_compressed`: text would
// round. PCL's own writer is not used because it rounds VIEWPOINT to 6 digits.
// The file appears whole or not at all (replace_file). Throws std::runtime_error.
void write_pcd(const std::filesystem::path& file, const PcdCloud& cloud);

}  // namespace cleave::client
