// Options of the commands that join the stream.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cleave/commands/command.hpp"
#include "libcleave/stream.hpp"

namespace cleave::client {

struct LiveOptions {
  std::optional<std::uint32_t> domain;
  bool no_shared_memory = false;
  std::string sensor;  // empty: the only one there is
};

// --domain and --no-shared-memory.
void add_stream_options(CLI::App& command, LiveOptions& options);
// --sensor, checked.
void add_sensor_option(CLI::App& command, LiveOptions& options);

// The domain of the command line, else of CLEAVE_DOMAIN, else 0. Throws UsageError for a
// CLEAVE_DOMAIN that is no domain.
[[nodiscard]] StreamOptions stream_options(const LiveOptions& options);

}  // namespace cleave::client
