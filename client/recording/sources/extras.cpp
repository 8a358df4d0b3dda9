// SPDX-License-Identifier: BSD-3-Clause
#include "recording/sources/extras.hpp"

#include <spdlog/spdlog.h>

#include "recording/mcap/reader.hpp"

namespace cleave::recording {

std::size_t copy_extras(const std::filesystem::path& mcap, FrameSink& sink) {
  const McapReader reader(mcap);
  std::size_t damaged = 0;
  for (const Attachment& attachment : reader.contents().attachments) {
    try {
      sink.add_attachment(attachment, reader.read(attachment));
    } catch (const DataError& error) {
      spdlog::warn("attachment '{}': {}", attachment.name, error.what());
      ++damaged;
    }
  }
  for (const Metadata& metadata : reader.contents().metadata) sink.add_metadata(metadata);
  return damaged;
}

}  // namespace cleave::recording
