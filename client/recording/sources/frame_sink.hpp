// SPDX-License-Identifier: BSD-3-Clause
// Where `cleave convert` puts frames.
#pragma once

#include <filesystem>
#include <memory>

#include "recording/frames/frame.hpp"
#include "recording/mcap/format.hpp"

namespace cleave::recording {

class FrameSink {
 public:
  FrameSink() = default;
  virtual ~FrameSink() = default;
  FrameSink(const FrameSink&) = delete;
  FrameSink& operator=(const FrameSink&) = delete;

  virtual void write(Frame frame) = 0;
  // For what has a place for them: recordings. `content` is that of the attachment's record.
  virtual void add_attachment(const Attachment& /*attachment*/, ByteView /*content*/) {}
  virtual void add_metadata(const Metadata& /*metadata*/) {}
  // After the last frame.
  virtual void close() = 0;
};

// A path that ends in .mcap is a recording, any other a folder of PCD files (made if need be):
// frame_000001.pcd, ..., with the field `label` where the recording has label maps. Throws
// std::runtime_error when it exists already.
[[nodiscard]] std::unique_ptr<FrameSink> open_frame_sink(const std::filesystem::path& path);

// Throws std::runtime_error, with advice, when there is such a file: recordings are not replaced.
void refuse_existing(const std::filesystem::path& path);
// Throws std::runtime_error when the folder that it would be written into is not there.
void refuse_without_folder(const std::filesystem::path& path);

}  // namespace cleave::recording
