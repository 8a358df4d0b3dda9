// SPDX-License-Identifier: BSD-3-Clause
#include "config/stream_config.hpp"

#include "idl/interface_name.hpp"
#include "idl/topics.hpp"

namespace cleave::config {

StreamConfig read_stream_config(Section& file) {
  StreamConfig config;
  Section section = file.section("stream");
  section.integer("domain", config.domain, 0, 99);
  section.boolean("shared_memory", config.shared_memory);
  section.text("public_interface", config.public_interface);
  if (!is_interface_name(config.public_interface)) {
    section.refuse("public_interface", "the name or address of a network interface");
  }
  return config;
}

void read_mode(Section& file, Mode& mode) {
  auto index = static_cast<std::size_t>(mode);
  file.choice("mode", index, {"live", "lossless"});
  mode = static_cast<Mode>(index);
}

void check_sensor_name(const Section& file, std::string_view key, const std::string& name) {
  if (is_valid_sensor_name(name)) return;
  file.refuse(key, "a sensor name of 1 to 63 letters, digits or '_' (it is part of topic names)");
}

}  // namespace cleave::config
