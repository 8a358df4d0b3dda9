// SPDX-License-Identifier: BSD-3-Clause
// Options of the commands that join the stream.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "console/command.hpp"
#include "libcleave/stream.hpp"

namespace cleave::client {

// How long a sensor may take to be seen: one that runs, and one that is about to be started.
inline constexpr std::chrono::seconds sensor_patience{10};
inline constexpr std::chrono::seconds starting_sensor_patience{30};
// From one look at what asks to end to the next.
inline constexpr std::chrono::milliseconds longest_wait{100};

// Where else the nodes may be that are not seen.
inline constexpr char elsewhere[] =
    "name another domain with --domain or CLEAVE_DOMAIN, or the network interface that leads to "
    "another machine with --interface or CLEAVE_INTERFACE";

struct LiveOptions {
  std::optional<std::uint32_t> domain = {};
  bool no_shared_memory = false;
  std::string interface = {};  // empty: CLEAVE_INTERFACE, else loopback
  std::string sensor = {};     // empty: the only one there is
};

// --domain, --interface and --no-shared-memory.
void add_stream_options(CLI::App& command, LiveOptions& options);
// --sensor, checked.
void add_sensor_option(CLI::App& command, LiveOptions& options);

// Domain and interface of the command line, else of CLEAVE_DOMAIN and CLEAVE_INTERFACE, else 0 and
// loopback. Throws UsageError for a CLEAVE_DOMAIN that is no domain.
[[nodiscard]] StreamOptions stream_options(const LiveOptions& options);

}  // namespace cleave::client
