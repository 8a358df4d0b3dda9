// SPDX-License-Identifier: BSD-3-Clause
// What a recording holds beside frames.
#pragma once

#include <cstddef>
#include <filesystem>

#include "recording/sources/frame_sink.hpp"

namespace cleave::recording {

// Attachments and metadata of an MCAP file go into the sink, which may have no place for them.
// Returns how many were damaged: these are named and left out. Throws FileError.
[[nodiscard]] std::size_t copy_extras(const std::filesystem::path& mcap, FrameSink& sink);

}  // namespace cleave::recording
