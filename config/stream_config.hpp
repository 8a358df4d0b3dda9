// SPDX-License-Identifier: BSD-3-Clause
// The section `stream` that every node's file has: which domain, over what.
#pragma once

#include <cstdint>
#include <string>

#include "config/section.hpp"

namespace cleave::config {

// What becomes of frames that cannot be segmented in time.
enum class Mode {
  live,     // dropped and counted: the newest frame matters
  lossless  // none is dropped: the grabber waits for the segment lists of earlier frames
};

struct StreamConfig {
  std::uint32_t domain = 0;             // public DDS domain, 0 to 99; the bulk domain is 100 above
  bool shared_memory = true;            // off: clouds and label maps are copied over loopback
  std::string public_interface = "lo";  // network interface, by name or address
};

// All of these throw ConfigurationError.
[[nodiscard]] StreamConfig read_stream_config(Section& file);
void read_mode(Section& file, Mode& mode);
// The rule of idl/topics.hpp.
void check_sensor_name(const Section& file, std::string_view key, const std::string& name);

}  // namespace cleave::config
