// SPDX-License-Identifier: BSD-3-Clause
// How much of one core a node uses while frames flow.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "libcleave/status.hpp"

namespace cleave::client {

class CpuShare {
 public:
  // Reports of one node, in order. One of another process starts anew.
  void add(const NodeReport& report, std::chrono::steady_clock::time_point now);
  // From the last report before the first frame to the last one that counted a new frame; 0 before
  // there are two of them.
  [[nodiscard]] double share() const;

 private:
  struct Moment {
    std::uint32_t process_id;
    std::uint64_t frames;
    double cpu_time_s;
    std::chrono::steady_clock::time_point time;
  };
  std::optional<Moment> first_, last_;
};

}  // namespace cleave::client
