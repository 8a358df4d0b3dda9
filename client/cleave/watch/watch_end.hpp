// SPDX-License-Identifier: BSD-3-Clause
// When `cleave watch` has seen enough, and why.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "cleave/watch/frame_account.hpp"

namespace cleave::client {

enum class WatchEnd {
  interrupted,     // by a signal
  frames_reached,  // --frames
  source_ended,    // and all its frames are accounted for
  nothing_arrives  // no segment list for 30 s
};

class EndCondition {
 public:
  // `frames`: segment lists to wait for; empty = no limit.
  EndCondition(std::optional<std::uint64_t> frames, SteadyTime start)
      : frames_(frames), last_arrival_(start) {}

  void add_segment_list(SteadyTime now);
  [[nodiscard]] std::optional<WatchEnd> check(const FrameAccount& account, SteadyTime now) const;

 private:
  std::optional<std::uint64_t> frames_;
  std::uint64_t lists_ = 0;
  SteadyTime last_arrival_;
};

// What the nodes' statuses say about a stream without segment lists, and what to do.
[[nodiscard]] std::string why_nothing_arrives(const FrameAccount& account,
                                              const std::string& sensor, std::uint32_t domain);

}  // namespace cleave::client
