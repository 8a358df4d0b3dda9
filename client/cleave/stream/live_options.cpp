// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/stream/live_options.hpp"

#include <CLI/CLI.hpp>

#include "idl/topics.hpp"

namespace cleave::client {

void add_stream_options(CLI::App& command, LiveOptions& options) {
  command.add_option("--domain", options.domain, "DDS domain, 0 to 99; else CLEAVE_DOMAIN, else 0")
      ->check(CLI::Range(0, 99));
  command.add_flag("--no-shared-memory", options.no_shared_memory,
                   "take clouds and label maps over the network");
}

void add_sensor_option(CLI::App& command, LiveOptions& options) {
  const auto refuse_bad_name = [](const std::string& name) {
    return is_valid_sensor_name(name)
               ? std::string()
               : "'" + name + "' is no sensor name: 1 to 63 letters, digits or '_'";
  };
  command.add_option("--sensor", options.sensor, "name of the sensor; not needed for the only one")
      ->check(CLI::Validator(refuse_bad_name, "NAME"));
}

StreamOptions stream_options(const LiveOptions& options) {
  StreamOptions result;
  result.shared_memory = !options.no_shared_memory;
  if (options.domain) {
    result.domain = *options.domain;
    return result;
  }
  try {
    return with_environment(result);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

}  // namespace cleave::client
