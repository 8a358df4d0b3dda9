// What a recording holds beside frames.
#pragma once

#include <cstddef>
#include <filesystem>

#include "cleave/recording/frame_sink.hpp"

namespace cleave::client {

// Attachments and metadata of an MCAP file go into the sink, which may have no place for them.
// Returns how many were damaged: these are named and left out. Throws recording::FileError.
[[nodiscard]] std::size_t copy_extras(const std::filesystem::path& mcap, FrameSink& sink);

}  // namespace cleave::client
