// SPDX-License-Identifier: BSD-3-Clause
// Frames out of a recording.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "recording/cdr/lacking_fields.hpp"
#include "recording/frames/frame.hpp"
#include "recording/frames/frame_input.hpp"
#include "recording/frames/ros_messages.hpp"
#include "recording/mcap/reader.hpp"
#include "recording/problems.hpp"

namespace cleave::recording {

// Which frames are wanted. What is not is not decoded.
struct Selection {
  std::set<Kind> kinds = {Kind::cloud, Kind::labels, Kind::segments};
  std::string sensor;  // empty: all
  // Seconds from the file's first message.
  double start_s = 0;
  std::optional<double> end_s;
};

// Frames come in the order of their log times. Frames that are damaged are passed over and
// named in problems() and counted in losses(); messages of other recorders, too, without a word.
// Deterministic.
class FrameReader : public FrameInput {
 public:
  // Throws FileError: it cannot be opened, is no MCAP, or holds nothing at all.
  explicit FrameReader(const std::filesystem::path& path, Selection selection = {});

  [[nodiscard]] std::optional<Frame> next() override;
  void rewind() override;
  [[nodiscard]] std::vector<std::string> problems() const override;
  [[nodiscard]] std::map<std::string, std::uint64_t> losses() const override;

  [[nodiscard]] const McapReader& mcap() const { return mcap_; }
  // Seconds from the first to the last message.
  [[nodiscard]] double duration_s() const;

 private:
  // What has come of a frame that is not complete.
  struct Parts {
    std::uint32_t number = 0;
    std::optional<ReceivedImage> depth;
    std::optional<Intrinsics> intrinsics;
    std::optional<std::vector<float>> points;
    std::optional<ReceivedImage> labels;
  };
  void begin();
  [[nodiscard]] std::optional<Frame> add(const Message& message);
  // Throws DataError for a schema of another contract.
  [[nodiscard]] const LackingFields& lacking_in(const Schema& schema);
  [[nodiscard]] Cloud complete_cloud(const Message& message, Parts& parts);
  [[nodiscard]] Labels complete_labels(const Message& message, Parts& parts);
  [[nodiscard]] bool wants(Kind kind) const { return selection_.kinds.contains(kind); }

  McapReader mcap_;
  Selection selection_;
  std::map<std::string, Parts> parts_;                             // by sensor
  std::map<const Schema*, std::optional<LackingFields>> lacking_;  // nothing: of another contract
  Problems problems_;                                              // beyond the container's
};

// The sensors whose clouds, label maps or segment lists a complete recording holds; empty for one
// that was cut off, whose topics nobody has listed.
[[nodiscard]] std::set<std::string> sensors_of(const Contents& contents);

}  // namespace cleave::recording
