// SPDX-License-Identifier: BSD-3-Clause
// cleave-grabber: a depth camera, or recordings, to cleave/<sensor>/cloud.
#include <spdlog/spdlog.h>

#include <exception>
#include <memory>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <variant>

#include "libcleave/process/exit_codes.hpp"
#include "libcleave/process/logging.hpp"
#include "libcleave/process/restart.hpp"
#include "libcleave/process/sensor_lock.hpp"
#include "libcleave/process/shutdown.hpp"
#include "libcleave/roudi.hpp"
#include "libcleave/stream.hpp"
#include "sensor/grabber/command_line.hpp"
#include "sensor/grabber/grabber.hpp"
#include "sensor/sources/make_source.hpp"

namespace cleave::sensor {
namespace {

StreamOptions stream_options(const config::StreamConfig& config) {
  return with_environment({config.domain, config.shared_memory, config.public_interface});
}

GrabberOptions grabber_options(const Settings& settings, bool realtime) {
  const config::GrabberConfig& config = settings.config;
  const auto& [position, orientation] =
      std::tie(config.calibration.position, config.calibration.orientation);
  GrabberOptions options;
  options.sensor = config.sensor;
  options.coordinate_frame = coordinate_frame_of(config);
  options.parent_frame = config.calibration.parent_frame;
  options.pose = {{position.x, position.y, position.z},
                  {orientation.x, orientation.y, orientation.z, orientation.w}};
  options.fps = config.fps;
  options.max_frames = settings.max_frames;
  if (config.mode == config::Mode::lossless) options.window = config.window;
  options.endless = !options.window && !options.max_frames && (realtime || config.loop);
  return options;
}

// Every reader and writer is gone when this returns.
Ending run(const Settings& settings, std::unique_ptr<Source> source, const StreamOptions& options,
           Shutdown& shutdown) {
  const config::GrabberConfig& config = settings.config;
  const SensorLock lock(options.domain, config.sensor);
  Stream stream(options);
  spdlog::info("sensor '{}' from {}, {} ({})", config.sensor, config.source,
               to_string(stream.transport()), stream.transport_reason());
  return Grabber(grabber_options(settings, source->realtime()), stream, *source, shutdown).run();
}

int run(int argc, char** argv) {
  try {
    const std::variant<Settings, int> parsed = read_command_line(argc, argv);
    if (const int* const code = std::get_if<int>(&parsed)) return *code;
    const Settings& settings = std::get<Settings>(parsed);
    const config::GrabberConfig& config = settings.config;
    const StreamOptions options = stream_options(config.stream);
    const VideoMode mode{config.video.width, config.video.height, config.fps,
                         config.video.registration, config.video.mirror};
    const Playback playback{config.loop, recording::unit_named(config.unit),
                            recording::GapLimit(config.max_gap_s)};
    const config::CalibrationConfig& known = config.calibration;
    const Calibration calibration{{known.fx, known.fy, known.cx, known.cy}, known.depth_scale};
    auto source = make_source(config.source, mode, playback, {config.decimate, calibration});
    Shutdown shutdown;
    const Ending ending = run(settings, std::move(source), options, shutdown);
    if (ending == Ending::start_anew) {
      if (const pid_t roudi = shutdown.roudi()) leave_roudi(roudi);
      restart_in_place(argv);
    }
    return ending == Ending::done ? exit_done : exit_failed;
  } catch (const config::ConfigurationError& error) {
    spdlog::error("{}", error.what());
    return exit_wrong_usage;
  } catch (const std::invalid_argument& error) {  // a source or CLEAVE_DOMAIN
    spdlog::error("{}", error.what());
    return exit_wrong_usage;
  } catch (const std::exception& error) {
    spdlog::error("{}", error.what());
    return exit_failed;
  }
}

}  // namespace
}  // namespace cleave::sensor

int main(int argc, char** argv) {
  cleave::init_logging("cleave-grabber");
  return cleave::sensor::run(argc, argv);
}
