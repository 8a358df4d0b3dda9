// SPDX-License-Identifier: BSD-3-Clause
// A rendered frame as a PCD file.
#pragma once

#include <filesystem>

#include "sensor/renderer/labelled_depth.hpp"
#include "sensor/renderer/view/camera.hpp"

namespace cleave::render {

// Organised, binary_compressed; fields x, y, z (metres, optical frame, NaN = no measurement) and
// label (uint32, numbers as LabelledDepth says). The same frame gives the same bytes. The file
// appears whole or not at all. Throws std::runtime_error.
void write_labelled_pcd(const std::filesystem::path& file, const LabelledDepth& image,
                        const Intrinsics& intrinsics);

}  // namespace cleave::render
