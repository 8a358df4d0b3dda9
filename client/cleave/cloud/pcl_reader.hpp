// The one place that uses PCL's file reader.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "cleave/cloud/pcd_header.hpp"

namespace cleave::client {

// The points' bytes, fields in the header's order, padding ("_") left out. The header has been
// checked against the file. Throws PcdError when PCL cannot read it or finds another layout.
[[nodiscard]] std::vector<std::uint8_t> read_points_with_pcl(const std::filesystem::path& file,
                                                             const PcdHeader& header);

}  // namespace cleave::client
