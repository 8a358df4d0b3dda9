// SPDX-License-Identifier: BSD-3-Clause
#include "segmenter/settings.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <stdexcept>
#include <thread>

#include "config/section.hpp"
#include "config/segmenter_config.hpp"
#include "idl/topics.hpp"
#include "libcleave/process/settings_file.hpp"
#include "segmentation/ignored_options.hpp"
#include "segmentation/option_visitor.hpp"
#include "segmenter/option_binder.hpp"
#include "segmenter/pipeline/result_sink.hpp"

namespace cleave::service {
namespace {

static_assert(config::max_workers < ResultSink::max_loans);
constexpr std::size_t lossless_queue = 8;  // beyond the window of frames that the grabber keeps

segmentation::Options read_options(config::Section section) {
  segmentation::Options options;
  OptionBinder binder(section);
  segmentation::visit_options(options, binder);
  if (const auto ignored =
          segmentation::find_ignored_option(options, std::array{segmentation::Options{}})) {
    binder.refuse(ignored->name, "no value, as " + ignored->why + " (or " + ignored->remedy + ")");
  }
  return options;
}

void check_sensor(const std::string& name) {
  if (is_valid_sensor_name(name)) return;
  throw std::invalid_argument("--sensor: expected 1 to 63 letters, digits or '_', found '" + name +
                              "'");
}

// For each sensor: as asked for, or a fair share of the cores.
std::size_t workers_of(const config::SegmenterConfig& config, const CommandLine& line,
                       std::size_t sensors) {
  if (line.workers) return *line.workers;
  const std::size_t workers =
      config::worker_count(config, std::max(1U, std::thread::hardware_concurrency()));
  if (config.workers > 0) return workers;
  return std::max<std::size_t>(workers / sensors, 1);
}

}  // namespace

DaemonSettings read_settings(const CommandLine& line) {
  config::Section file =
      config::Section::load(line.config_file.empty() ? settings_file("segmenter.yaml")
                                                     : std::filesystem::path(line.config_file));
  const config::SegmenterConfig config = config::read_segmenter_config(file);
  DaemonSettings settings;
  settings.segmentation = read_options(file.section("segmentation"));
  file.finish();
  if (line.sensor) check_sensor(*line.sensor);
  settings.sensors = line.sensor ? std::vector{*line.sensor} : config.sensors;
  settings.workers = workers_of(config, line, settings.sensors.size());
  const bool lossless = line.lossless || config.mode == config::Mode::lossless;
  settings.mode = lossless ? Mode::lossless : Mode::live;
  settings.queue_capacity = lossless ? lossless_queue : config.queue;
  settings.check_unit = config.check_unit;
  settings.stream =
      with_environment({config.stream.domain, config.stream.shared_memory && !line.no_shared_memory,
                        config.stream.public_interface});
  return settings;
}

}  // namespace cleave::service
