// SPDX-License-Identifier: BSD-3-Clause
#include "config/segmenter_config.hpp"

#include <algorithm>

#include "idl/topics.hpp"

namespace cleave::config {
namespace {

void check_sensors(const Section& file, const std::vector<std::string>& sensors) {
  if (sensors.empty()) file.refuse("sensors", "at least one sensor");
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    if (!is_valid_sensor_name(sensors[i])) {
      file.refuse("sensors", "names of 1 to 63 letters, digits or '_' (not '" + sensors[i] + "')");
    }
    const auto end = sensors.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(sensors.begin(), end, sensors[i]) != end) {
      file.refuse("sensors", "each sensor once (not '" + sensors[i] + "' twice)");
    }
  }
}

}  // namespace

SegmenterConfig read_segmenter_config(Section& file) {
  SegmenterConfig config;
  file.list("sensors", config.sensors);
  check_sensors(file, config.sensors);
  file.integer("workers", config.workers, 0, max_workers);
  file.integer("queue", config.queue, 1, 8);
  read_mode(file, config.mode);
  file.boolean("check_unit", config.check_unit);
  config.stream = read_stream_config(file);
  return config;
}

std::uint32_t worker_count(const SegmenterConfig& config, std::uint32_t cores) {
  if (config.workers > 0) return config.workers;
  return std::clamp(cores, std::uint32_t{2}, max_workers + 1) - 1;
}

}  // namespace cleave::config
