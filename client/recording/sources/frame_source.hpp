// SPDX-License-Identifier: BSD-3-Clause
// Where `cleave convert` and `cleave segment` take frames from. A new kind of input is one more
// file here, a line in open_frame_source(), and its ending in is_recording().
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "recording/frames/frame.hpp"
#include "recording/ros/file_topic.hpp"
#include "recording/units/unit.hpp"

namespace cleave::recording {

class FrameSource {
 public:
  FrameSource() = default;
  virtual ~FrameSource() = default;
  FrameSource(const FrameSource&) = delete;
  FrameSource& operator=(const FrameSource&) = delete;

  // Empty at the end. Throws when nothing more can be read, and WrongUnit at the first
  // cloud of a recording that seems to be in millimetres while no unit was named.
  [[nodiscard]] virtual std::optional<Frame> next() = 0;
  // What could not be read and was passed over, so far.
  [[nodiscard]] virtual std::size_t skipped() const = 0;
};

// By the kind of its path: an MCAP file (bag.mcap, bag.mcap?topic=T, mcap:bag.mcap), an .oni file,
// a PCD file or a folder of them. `sensor` names what has no name of its own. `unit` is that of the
// clouds, which are scaled to metres; without one, millimetres are refused: each PCD file for
// itself, and a recording by its first cloud. With a decimation of 2 and more, a block of so many
// pixels a side becomes one, and files may have so many more points (Decimator). Throws
// UnknownInput for any other kind, and for an .oni file with a unit, which it has itself;
// std::runtime_error for what cannot be opened.
[[nodiscard]] std::unique_ptr<FrameSource> open_frame_source(const std::string& input,
                                                             const std::string& sensor,
                                                             std::optional<Unit> unit = {},
                                                             std::uint32_t decimation = 1);

// Whether it is an MCAP file, by its name.
[[nodiscard]] bool is_mcap(const std::string& input);
// Whether it is an MCAP or .oni file, by its name.
[[nodiscard]] bool is_recording(const std::string& input);
// The MCAP file and the topic that an input names, with or without `mcap:` before them.
[[nodiscard]] FileTopic mcap_input(const std::string& input);

// One for each kind.
[[nodiscard]] std::unique_ptr<FrameSource> open_mcap(const FileTopic& from,
                                                     const std::string& sensor,
                                                     std::optional<Unit> unit);
[[nodiscard]] std::unique_ptr<FrameSource> open_pcd(const std::filesystem::path& path,
                                                    const std::string& sensor,
                                                    std::optional<Unit> unit,
                                                    std::uint64_t max_points);
[[nodiscard]] std::unique_ptr<FrameSource> decimate(std::unique_ptr<FrameSource> source,
                                                    std::uint32_t factor);
[[nodiscard]] std::unique_ptr<FrameSource> open_oni(const std::filesystem::path& path,
                                                    const std::string& sensor);

}  // namespace cleave::recording
