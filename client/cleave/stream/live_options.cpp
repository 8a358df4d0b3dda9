// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/stream/live_options.hpp"

#include <CLI/CLI.hpp>

#include "idl/interface_name.hpp"
#include "idl/topics.hpp"

namespace cleave::client {
namespace {

std::string refuse_bad_interface(const std::string& name) {
  return is_interface_name(name) ? "" : "'" + name + "' is no name or address of an interface";
}

}  // namespace

void add_stream_options(CLI::App& command, LiveOptions& options) {
  command.add_option("--domain", options.domain, "DDS domain, 0 to 99; else CLEAVE_DOMAIN, else 0")
      ->check(CLI::Range(0, 99));
  command
      .add_option("--interface", options.interface,
                  "network interface, by name or address, of segment lists and status, to look "
                  "at another machine; else CLEAVE_INTERFACE, else lo")
      ->check(CLI::Validator(refuse_bad_interface, "NAME"));
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
  try {
    // What the command line says, nobody asks the environment for.
    if (!options.domain || options.interface.empty()) result = with_environment(result);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  if (options.domain) result.domain = *options.domain;
  if (!options.interface.empty()) result.public_interface = options.interface;
  return result;
}

}  // namespace cleave::client
