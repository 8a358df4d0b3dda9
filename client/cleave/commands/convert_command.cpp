// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/commands/convert_command.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>

#include "cleave/stream/live_options.hpp"
#include "console/live_line.hpp"
#include "console/terminal.hpp"
#include "console/unit_option.hpp"
#include "idl/capacity.hpp"
#include "recording/error.hpp"
#include "recording/sources/extras.hpp"
#include "recording/sources/frame_sink.hpp"
#include "recording/sources/frame_source.hpp"

namespace cleave::client {
namespace {

struct ConvertOptions {
  std::string input;
  std::string output;
  UnitArgument unit;
  std::uint32_t decimation = 1;
  LiveOptions sensor;
};

int convert(const ConvertOptions& options, recording::FrameSource& source,
            recording::FrameSink& sink) {
  const bool terminal = is_terminal(STDERR_FILENO);
  LiveLine line(std::cerr, live_columns(STDERR_FILENO));
  std::size_t frames = 0;
  std::map<std::string, std::size_t> refused;  // by what the output says
  while (auto frame = source.next()) {
    try {
      sink.write(std::move(*frame));
      ++frames;
    } catch (const recording::DataError& error) {
      ++refused[error.what()];
    }
    if (terminal) line.show(std::to_string(frames) + " frames");
  }
  std::size_t lost_extras = 0;
  if (recording::is_mcap(options.input))
    lost_extras = recording::copy_extras(recording::mcap_input(options.input).file, sink);
  sink.close();
  line.erase();
  std::cout << options.output << ": " << frames << " frames";
  if (source.skipped() > 0) std::cout << ", " << source.skipped() << " could not be read";
  for (const auto& [why, count] : refused) {
    std::cout << ", " << count << " left out: " << why;
  }
  std::cout << '\n';
  if (frames == 0) std::filesystem::remove(options.output);  // a recording, or a folder, of nothing
  const bool whole = refused.empty() && source.skipped() == 0 && lost_extras == 0;
  return frames > 0 && whole ? exit_done : exit_failed;
}

// A conversion that fails leaves nothing behind, for what exists already is not replaced.
int run(const ConvertOptions& options) {
  const std::string& sensor = options.sensor.sensor;
  const auto source = recording::open_frame_source(
      options.input, sensor.empty() ? "camera" : sensor, options.unit.unit(), options.decimation);
  const auto sink = recording::open_frame_sink(options.output);
  try {
    return convert(options, *source, *sink);
  } catch (...) {
    std::error_code ignored;  // the failure that is reported is the first one
    std::filesystem::remove_all(options.output, ignored);
    throw;
  }
}

}  // namespace

void add_convert_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<ConvertOptions>();
  CLI::App* command =
      app.add_subcommand("convert", "Between MCAP recordings and PCD files, and from .oni");
  command
      ->add_option("INPUT", options->input,
                   "recording (.mcap, .mcap?topic=T or .oni), PCD file, or\n"
                   "folder of them")
      ->required();
  command->add_option("OUTPUT", options->output, "recording (.mcap), or a folder for PCD files")
      ->required();
  add_sensor_option(*command, options->sensor);
  add_unit_option(*command, options->unit);
  command
      ->add_option("--decimate", options->decimation,
                   "a block of so many pixels a side becomes one point: for\n"
                   "more than " +
                       capacity_text())
      ->check(CLI::Range(1, 4));
  command->footer(
      "Examples:\n"
      "  cleave convert scenes/ scenes.mcap\n"
      "  cleave convert run.mcap run_pcd/\n"
      "  cleave convert table.oni table.mcap\n"
      "  cleave convert d435_848x480/ small.mcap --decimate 2\n"
      "  cleave convert 'bag.mcap?topic=/camera/depth/points' table.mcap\n"
      "\n"
      "Of a bag of ROS 2 in MCAP, the clouds (PointCloud2) or depth images (Image and\n"
      "CameraInfo) of one topic are taken; `cleave info` lists what can be.\n"
      "PCD files become frames of the sensor `camera` (--sensor) at 30 frames a second. The\n"
      "depth of an .oni file becomes frames of that sensor with the file's own time stamps,\n"
      "and with the points that cleave-grabber publishes when it plays the file.\n"
      "Frames become frame_000001.pcd, ..., with the field label where label maps were\n"
      "recorded. Attachments and metadata go from recording to recording.\n"
      "What cannot be read is named, left out, and makes the exit code 1; a conversion that\n"
      "fails as a whole leaves no OUTPUT.");
  command->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace cleave::client
