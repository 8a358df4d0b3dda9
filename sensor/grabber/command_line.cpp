// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/grabber/command_line.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "idl/topics.hpp"
#include "libcleave/process/exit_codes.hpp"
#include "libcleave/process/settings_file.hpp"
#include "recording/units/unit.hpp"

namespace cleave::sensor {
namespace {

constexpr char examples[] =
    "Sources:\n"
    "  openni2:          the first camera that OpenNI2 finds\n"
    "  openni2:URI       one camera\n"
    "  openni2:serial=N  the camera with this serial number\n"
    "  synthetic:SCENE   the synthetic camera\n"
    "  pcd:PATH          a point cloud, or a folder of them in natural order\n"
    "  oni:FILE          a recording by OpenNI\n"
    "  mcap:FILE         a recording by `cleave record`, in its own timing\n"
    "  mcap:FILE?topic=T the clouds or depth images of one topic of a bag of ROS 2\n"
    "\n"
    "Examples:\n"
    "  cleave-grabber --config grabber.yaml\n"
    "  cleave-grabber --config grabber.yaml --source synthetic:medium --frames 300\n"
    "  cleave-grabber --config grabber.yaml --source pcd:recordings --lossless\n"
    "  cleave-grabber --config grabber.yaml --source oni:table.oni --lossless\n"
    "  cleave-grabber --config grabber.yaml --source pcd:scene.pcd --loop --fps 10\n"
    "  cleave-grabber --config grabber.yaml --source pcd:scans --unit mm\n"
    "  cleave-grabber --config grabber.yaml --source synthetic:medium --size 1280x720\n"
    "  cleave-grabber --config grabber.yaml --source pcd:kinect_1920x1080 --decimate 2\n"
    "\n"
    "Ends with 0 when it is done, 1 when it failed, 2 for wrong usage or configuration.\n"
    "CLEAVE_DOMAIN overrides the DDS domain, CLEAVE_INTERFACE the network interface,\n"
    "CLEAVE_LOG sets the log level (trace to error).\n";

// "848x480"; nothing for another text.
std::optional<config::ImageSize> size_of(std::string_view text) {
  const std::size_t cross = text.find('x');
  if (cross == std::string_view::npos) return std::nullopt;
  config::ImageSize size;
  const auto read = [](std::string_view digits, std::optional<std::uint32_t>& number) {
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(digits.begin(), digits.end(), value);
    number = value;
    return error == std::errc{} && end == digits.end() && value >= 16 && value <= 4096;
  };
  if (!read(text.substr(0, cross), size.width)) return std::nullopt;
  if (!read(text.substr(cross + 1), size.height)) return std::nullopt;
  return size;
}

std::string check_size(const std::string& text) {
  return size_of(text) ? "" : "expected WIDTHxHEIGHT, each from 16 to 4096, e.g. 848x480";
}

std::string check_sensor(const std::string& name) {
  return is_valid_sensor_name(name) ? "" : "expected 1 to 63 letters, digits or '_'";
}

}  // namespace

std::variant<Settings, int> read_command_line(int argc, char** argv) {
  CLI::App app("Publishes the frames of a depth camera, or of recordings, as clouds.",
               "cleave-grabber");
  app.footer(examples);
  app.set_version_flag("--version", version_text(CLEAVE_VERSION));
  std::string file;
  std::optional<std::string> source, sensor, unit, size;
  std::optional<std::uint32_t> fps, decimate;
  std::optional<std::uint64_t> frames;
  std::optional<double> max_gap_s;
  bool loop = false, lossless = false, no_shared_memory = false;
  app.add_option("--config", file,
                 "configuration file (YAML); else grabber.yaml of the installation");
  app.add_option("--source", source, "where frames come from, a URI as below");
  app.add_option("--sensor", sensor, "name of the sensor in the topics")
      ->check(CLI::Validator(check_sensor, "NAME"));
  app.add_option("--unit", unit, "unit of the points of pcd: and mcap:, scaled to metres")
      ->check(CLI::IsMember(
          std::vector<std::string>(recording::unit_names.begin(), recording::unit_names.end())));
  app.add_option("--fps", fps, "frames a second")->check(CLI::Range(1, 240));
  app.add_option("--size", size, "pixels asked of a camera, e.g. 848x480")
      ->check(CLI::Validator(check_size, "WIDTHxHEIGHT"));
  app.add_option("--decimate", decimate, "a block of so many pixels a side becomes one point")
      ->check(CLI::Range(1, 4));
  app.add_option("--frames", frames, "end after so many published frames")
      ->check(CLI::PositiveNumber);
  app.add_option("--max-gap", max_gap_s, "longest pause between two frames of mcap:, in seconds; 1")
      ->check(CLI::Range(0.0, 86'400.0));
  app.add_flag("--loop", loop, "start recordings again at their end");
  app.add_flag("--lossless", lossless, "publish a frame only when earlier ones are segmented");
  app.add_flag("--no-shared-memory", no_shared_memory, "send clouds over loopback");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_done : exit_wrong_usage;
  }
  config::ImageSize image = size ? *size_of(*size) : config::ImageSize{};
  image.decimate = decimate;
  if (file.empty()) file = settings_file("grabber.yaml");
  Settings settings{config::load_grabber_config(file, image), frames};
  config::GrabberConfig& config = settings.config;
  if (source) config.source = *source;
  if (sensor) config.sensor = *sensor;
  if (unit) config.unit = *unit;
  if (fps) config.fps = *fps;
  if (max_gap_s) config.max_gap_s = *max_gap_s;
  if (loop) config.loop = true;
  if (lossless) config.mode = config::Mode::lossless;
  if (no_shared_memory) config.stream.shared_memory = false;
  return settings;
}

}  // namespace cleave::sensor
