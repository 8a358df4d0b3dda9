// SPDX-License-Identifier: BSD-3-Clause
// Depth frames out of OpenNI's recordings (.oni), without OpenNI.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "recording/oni/file.hpp"
#include "recording/oni/stream_properties.hpp"

namespace cleave::oni {

struct DepthFrame {
  std::uint64_t timestamp_us = 0;    // OpenNI2's recorder begins at 0
  std::uint32_t index = 0;           // as recorded; OpenNI2's recorder counts from 1
  std::vector<std::uint16_t> depth;  // width * height, row-major, in units of unit_m; 0 = none
};

// The first depth stream of a recording by OpenNI 1 or 2, of any length: the file is read as frames
// are asked for, in any order. Nothing that the file says is believed before it is checked; of a
// damaged file, or one whose recorder was killed, the intact frames are there. The file's own seek
// table is not used. One thread at a time. Deterministic.
//
// Format: OpenNI2, Source/Core/OniDataRecords.h and Source/Drivers/OniFile.
class Reader {
 public:
  // Finds all frames. Throws std::runtime_error with the file, why it is of no use, and what to do:
  // not an .oni file, no depth stream, or one in a form that cannot be read.
  explicit Reader(const std::filesystem::path& path);

  [[nodiscard]] const DepthStream& stream() const { return stream_; }
  // How many frames there are.
  [[nodiscard]] std::size_t size() const { return frames_.size(); }
  // What is wrong with the file although frames are there; empty = nothing.
  [[nodiscard]] const std::string& damage() const { return damage_; }
  [[nodiscard]] std::uint64_t timestamp_us(std::size_t i) const { return frames_[i].timestamp_us; }
  // Reads frame `i` < size(); says which one and why where it is damaged (`frame` is then not to be
  // used). Memory in `frame` is reused.
  [[nodiscard]] std::optional<std::string> read(std::size_t i, DepthFrame& frame);

 private:
  struct Entry {
    std::uint64_t position;
    std::uint32_t bytes;
    std::uint32_t index;
    std::uint64_t timestamp_us;
  };
  void find_frames();

  File file_;
  std::string name_;
  DepthStream stream_;
  Codec codec_ = Codec::none;
  std::vector<Entry> frames_;
  std::string damage_;
  std::vector<std::uint8_t> buffer_;
};

}  // namespace cleave::oni
