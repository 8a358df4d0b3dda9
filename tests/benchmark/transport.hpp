// SPDX-License-Identifier: BSD-3-Clause
// What the two programs that benchmark_transport compares have in common: how a run goes and what a
// reader says of it. A cloud's latency is from just before its publication to its reader's hands.
#pragma once

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <iostream>
#include <optional>
#include <string>
#include <thread>

#include "libcleave/types.hpp"

namespace cleave::benchmark {

// PROGRAM write READERS CLOUDS | PROGRAM read CLOUDS
struct TransportRole {
  bool writes;
  unsigned readers;
  int clouds;
};

inline std::optional<TransportRole> transport_role(int argc, char** argv) {
  if (argc == 4 && std::strcmp(argv[1], "write") == 0) {
    return TransportRole{true, static_cast<unsigned>(std::stoul(argv[2])), std::stoi(argv[3])};
  }
  if (argc == 3 && std::strcmp(argv[1], "read") == 0) {
    return TransportRole{false, 0, std::stoi(argv[2])};
  }
  std::cerr << "usage: write READERS CLOUDS | read CLOUDS; started by benchmark_transport\n";
  return std::nullopt;
}

// RouDi connects what has matched within this time.
inline constexpr std::chrono::milliseconds connecting{500};
inline constexpr std::chrono::milliseconds transport_period{16};
// A reader that has had no cloud for so long has lost the rest.
inline constexpr std::chrono::seconds transport_silence{10};

// A full 640 x 480 frame's header. Its points are the camera's to write, and not part of this.
inline void stamp(DepthCloud& cloud, int id) {
  cloud.header = FrameHeader{};
  cloud.header.frame_id = static_cast<std::uint64_t>(id);
  cloud.header.width = 640;
  cloud.header.height = 480;
  cloud.header.publication_time_ns = monotonic_now_ns();
}

// A line of nanoseconds each on stdout, read by benchmark_transport.
inline void say_latency(const DepthCloud& cloud) {
  std::cout << monotonic_now_ns() - cloud.header.publication_time_ns << '\n';
}

}  // namespace cleave::benchmark
