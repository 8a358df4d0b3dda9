// SPDX-License-Identifier: BSD-3-Clause
// Frames one after the other, whoever recorded them.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "recording/frames/frame.hpp"

namespace cleave::recording {

class FrameInput {
 public:
  FrameInput() = default;
  virtual ~FrameInput() = default;
  FrameInput(const FrameInput&) = delete;
  FrameInput& operator=(const FrameInput&) = delete;

  // Empty at the end. Throws FileError when the disk fails.
  [[nodiscard]] virtual std::optional<Frame> next() = 0;
  // Begins again.
  virtual void rewind() = 0;
  // What was passed over, and why: the first 1000 of the container and of the frames. A copy.
  [[nodiscard]] virtual std::vector<std::string> problems() const = 0;
  // How much of it, by cause: all of it.
  [[nodiscard]] virtual std::map<std::string, std::uint64_t> losses() const = 0;
  // What a user should know of all the frames.
  [[nodiscard]] virtual std::vector<std::string> remarks() const { return {}; }
};

}  // namespace cleave::recording
