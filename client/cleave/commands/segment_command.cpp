#include "cleave/commands/segment_command.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "cleave/cloud/option_setter.hpp"
#include "cleave/cloud/pcd_writer.hpp"
#include "cleave/cloud/picture.hpp"
#include "cleave/cloud/png_file.hpp"
#include "cleave/cloud/segment_table.hpp"
#include "cleave/cloud/viewpoint.hpp"
#include "cleave/commands/segmentation_options.hpp"
#include "segmentation/segmenter.hpp"

namespace cleave::client {
namespace {

using segmentation::Outcome;
using segmentation::Segmentation;

struct SegmentOptions {
  std::string input;
  std::string output;
  std::string picture;    // empty = none
  std::string viewpoint;  // empty = as the file says
  bool json = false;
  SegmentationArguments segmentation;
};

segmentation::SensorPose viewpoint_of(const std::string& text) {
  try {
    return parse_viewpoint(text);
  } catch (const ViewpointError& error) {
    throw UsageError(error.what());
  }
}

Segmentation segment(const PcdCloud& cloud, std::vector<std::uint16_t>& labels,
                     const SegmentOptions& options) {
  segmentation::Segmenter segmenter(options_of(options.segmentation));
  Segmentation result;
  segmentation::CloudView view = cloud.view();
  if (!options.viewpoint.empty()) view.pose = viewpoint_of(options.viewpoint);
  const Outcome outcome = segmenter.segment(view, labels, result);
  if (outcome == Outcome::no_finite_point) {
    throw PcdError(
        options.input +
        ": no point has coordinates that are finite and not all 0; there is nothing to segment");
  }
  if (outcome == Outcome::bad_size) {
    throw PcdError(options.input + ": the segmentation takes no cloud of this size");
  }
  return result;
}

void print(const Segmentation& result, const PcdCloud& cloud, const SegmentOptions& options) {
  if (!options.json) {
    std::cout << segment_table(result);
    return;
  }
  Json segments = Json::array();
  for (const auto& segment : result.segments) segments.push_back(json_of(segment));
  Json borders = Json::array();
  for (const auto& border : result.borders) borders.push_back(json_of(border));
  std::cout << one_line({{"input", options.input},
                         {"output", options.output},
                         {"points", cloud.header().points()},
                         {"segments", segments},
                         {"borders", borders}})
            << '\n';
}

int run(const SegmentOptions& options) {
  PcdCloud cloud = PcdCloud::read(options.input);
  std::vector<std::uint16_t> labels(cloud.header().points());
  const Segmentation result = segment(cloud, labels, options);
  cloud.set_labels(labels);
  write_pcd(options.output, cloud);
  if (!options.picture.empty()) {
    write_png(options.picture, segment_picture(depth_image(cloud.view(), labels)));
  }
  print(result, cloud, options);
  return exit_done;
}

}  // namespace

void add_segment_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<SegmentOptions>();
  CLI::App* command = app.add_subcommand("segment", "Segments one PCD file, offline");
  command->add_option("INPUT", options->input, "PCD file with x, y, z, organised or not")
      ->required();
  command->add_option("OUTPUT", options->output, "PCD file to write: the input with label set")
      ->required();
  command->add_option("--picture", options->picture, "PNG with labels as colours over the depth");
  command
      ->add_option(
          "--viewpoint", options->viewpoint,
          "where the sensor stood, in the cloud's frame; else as the file's VIEWPOINT says, "
          "and where that is 0 0 0 1 0 0 0, as the points tell")
      ->type_name("X,Y,Z[,QW,QX,QY,QZ]");
  command->add_flag("--json", options->json, "one JSON object: points, segments, borders");
  add_segmentation_options(*command, options->segmentation);
  command->footer(
      "Examples:\n"
      "  cleave segment in.pcd out.pcd\n"
      "  cleave segment in.pcd out.pcd --picture out.png --set voxel.size_m=0.005\n"
      "  cleave segment map.pcd out.pcd --viewpoint 1.5,0,0.8\n"
      "\n"
      "OUTPUT keeps the points, their order and organisation, VIEWPOINT and every other field;\n"
      "label (uint32, 0 = no segment) is set in all points. It is binary if INPUT is, else\n"
      "binary_compressed, and appears whole or not at all.\n"
      "\n" +
      list_options());
  command->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace cleave::client
