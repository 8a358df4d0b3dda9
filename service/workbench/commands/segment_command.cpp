// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/commands/segment_command.hpp"

#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "console/picture/picture.hpp"
#include "console/picture/png_file.hpp"
#include "console/segment_table.hpp"
#include "console/unit_option.hpp"
#include "recording/pcd/writer.hpp"
#include "recording/sources/frame_source.hpp"
#include "recording/units/suspected_unit.hpp"
#include "segmentation/result_check.hpp"
#include "segmentation/segmenter.hpp"
#include "workbench/cloud/option_setter.hpp"
#include "workbench/cloud/pcd_view.hpp"
#include "workbench/cloud/points_view.hpp"
#include "workbench/cloud/recorded_segments.hpp"
#include "workbench/cloud/viewpoint.hpp"
#include "workbench/cloud/why_not_segmented.hpp"
#include "workbench/commands/segment_recording.hpp"
#include "workbench/commands/segmentation_options.hpp"

namespace cleave::workbench {
namespace {

using recording::PcdCloud;
using segmentation::Segmentation;

struct SegmentOptions {
  std::string input;
  std::string output;
  std::string picture;      // empty = none
  std::uint64_t frame = 0;  // of a recording, from 1; 0 = not given
  std::string viewpoint;    // empty = as the file says
  bool json = false;
  UnitArgument unit;
  SegmentationArguments segmentation;
};

std::optional<segmentation::SensorPose> viewpoint_of(const std::string& text) {
  if (text.empty()) return std::nullopt;
  try {
    return parse_viewpoint(text);
  } catch (const ViewpointError& error) {
    throw UsageError(error.what());
  }
}

Segmentation segment(const segmentation::CloudView& cloud, std::vector<std::uint16_t>& labels,
                     const segmentation::Options& settings, const std::string& name) {
  segmentation::Segmenter segmenter(settings);
  Segmentation result;
  const std::string_view why = why_not_segmented(segmenter.segment(cloud, labels, result));
  if (!why.empty()) throw std::runtime_error(name + ": " + std::string(why));
  const std::string_view advice = segmentation::advice_on(segmentation::doubt_about(result));
  if (!advice.empty()) spdlog::warn("{}: {}", name, advice);
  return result;
}

void print(const Segmentation& result, const PcdCloud& cloud, const SegmentOptions& options) {
  if (!options.json) {
    recording::SegmentList list;
    set_segments(list, result);
    std::cout << segment_table(list);
    return;
  }
  Json json = {
      {"input", options.input}, {"output", options.output}, {"points", cloud.header().points()}};
  json.update(segments_json(result));
  std::cout << one_line(json) << '\n';
}

// A recording's frames all go to a folder, one to a file.
bool is_folder(const std::string& output) {
  return std::filesystem::path(output).extension() != ".pcd";
}

PcdCloud read_frame(const SegmentOptions& options) {
  const std::uint64_t frame = std::max<std::uint64_t>(options.frame, 1);
  if (options.frame == 0) {
    spdlog::info("{}: frame 1 alone; --frame N takes another, a folder as OUTPUT takes all",
                 options.input);
  }
  return frame_of_recording(options.input, options.unit.unit(), frame);
}

int run(const SegmentOptions& options) {
  if (options.frame > 0 && (!recording::is_recording(options.input) || is_folder(options.output))) {
    throw UsageError("--frame is for one frame of a recording, and a .pcd file as OUTPUT");
  }
  const auto pose = viewpoint_of(options.viewpoint);
  const segmentation::Options settings = options_of(options.segmentation);
  std::optional<recording::Unit> unit = options.unit.unit();
  const bool is_of_recording = recording::is_recording(options.input);
  if (is_of_recording && is_folder(options.output)) {
    if (!options.picture.empty()) throw UsageError("--picture is of one frame: add --frame N");
    return segment_recording({options.input, options.output, options.json, unit, pose, settings});
  }
  PcdCloud cloud = is_of_recording ? read_frame(options) : PcdCloud::read(options.input);
  if (is_of_recording) unit = recording::Unit::metre;  // it was scaled as it was read
  std::vector<std::uint16_t> labels(cloud.header().points());
  std::vector<float> xyz(cloud.xyz().begin(), cloud.xyz().end());
  recording::make_metres(xyz, unit, options.input);
  segmentation::CloudView view = view_in_metres(cloud, xyz, unit);
  if (pose) view.pose = pose;
  const Segmentation result = segment(view, labels, settings, options.input);
  cloud.set_labels(labels);
  write_pcd(options.output, cloud);
  if (!options.picture.empty()) {
    write_png(options.picture, segment_picture(depth_image(points_of(view), labels)));
  }
  print(result, cloud, options);
  return exit_done;
}

}  // namespace

void add_segment_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<SegmentOptions>();
  CLI::App* command = app.add_subcommand("segment", "Segments a PCD file or a recording, offline");
  command
      ->add_option("INPUT", options->input,
                   "PCD file with x, y, z, organised or not; or a recording\n"
                   "(.mcap, .mcap?topic=T, .oni)")
      ->required();
  command
      ->add_option("OUTPUT", options->output,
                   "PCD file to write: the input with label set; for a\n"
                   "recording, a folder for all frames")
      ->required();
  command->add_option("--frame", options->frame, "of a recording, this one alone, from 1")
      ->check(CLI::PositiveNumber);
  command->add_option("--picture", options->picture, "PNG with labels as colours over the depth");
  command
      ->add_option("--viewpoint", options->viewpoint,
                   "where the sensor stood, in the cloud's frame; else as the\n"
                   "file's VIEWPOINT says, and where that is 0 0 0 1 0 0 0,\n"
                   "as the points tell")
      ->type_name("X,Y,Z[,QW,QX,QY,QZ]");
  command->add_flag("--json", options->json, "one JSON object: points, segments, borders");
  add_unit_option(*command, options->unit);
  add_segmentation_options(*command, options->segmentation);
  command->footer(
      "Examples:\n"
      "  cleave segment in.pcd out.pcd\n"
      "  cleave segment in.pcd out.pcd --picture out.png --set voxel.size_m=0.005\n"
      "  cleave segment 'bag.mcap?topic=/camera/depth/points' labelled/\n"
      "  cleave segment run.mcap third.pcd --frame 3\n"
      "  cleave segment scan.pcd out.pcd --unit mm\n"
      "  cleave segment map.pcd out.pcd --viewpoint 1.5,0,0.8\n"
      "\n"
      "OUTPUT keeps the points of a PCD file in their unit, their order and organisation,\n"
      "VIEWPOINT and every other field; label (uint32, 0 = no segment) is set in all points.\n"
      "It is binary if INPUT is, else binary_compressed, and appears whole or not at all.\n"
      "Frames of a recording are written in metres.\n"
      "\n" +
      list_options());
  command->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace cleave::workbench
