// SPDX-License-Identifier: BSD-3-Clause
// Whether RouDi has chunks for the large types. Asked before the first loan of one, for iceoryx
// ends a process that asks a pool for more than it has.
#pragma once

#include <cstdint>
#include <mutex>
#include <string>

#include "libcleave/stream.hpp"

namespace cleave {

class LargeChunks {
 public:
  // `bytes` of the large type. Where the network carries the samples there are always some.
  LargeChunks(const Stream& stream, std::uint32_t bytes)
      : bytes_(bytes), asked_(stream.transport() == Transport::network) {}

  // From any thread. Says in the log, once, what is in the way.
  [[nodiscard]] bool there();
  // What is in the way, and what to do about it; empty if nothing is, or nobody has asked.
  [[nodiscard]] std::string obstacle() const;

 private:
  const std::uint32_t bytes_;
  mutable std::mutex mutex_;  // guards the two below
  bool asked_;
  std::string obstacle_;
};

}  // namespace cleave
