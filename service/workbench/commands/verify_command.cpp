// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/commands/verify_command.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <thread>

#include "console/json.hpp"
#include "console/live_line.hpp"
#include "console/terminal.hpp"
#include "console/unit_option.hpp"
#include "recording/sources/frame_source.hpp"
#include "workbench/commands/segmentation_options.hpp"
#include "workbench/verification/verification.hpp"

namespace cleave::workbench {
namespace {

struct VerifyOptions {
  std::string input;
  std::string golden;
  bool update = false;
  Tolerances tolerances;
  std::size_t workers = std::max(1U, std::thread::hardware_concurrency());
  bool json = false;
  UnitArgument unit;
  SegmentationArguments segmentation;
};

std::string name_of(const recording::FrameHeader& header) {
  return fmt::format("frame {} (sensor {}, epoch {})", header.frame_id, header.sensor,
                     header.epoch);
}

void print(const FrameDifference& difference) {
  std::cout << name_of(difference.header) << '\n';
  for (const std::string& line : difference.lines) std::cout << "  " << line << '\n';
}

Json json_of(const FrameDifference& difference) {
  return {{"frame_id", difference.header.frame_id},
          {"epoch", difference.header.epoch},
          {"sensor", difference.header.sensor},
          {"differences", difference.lines}};
}

Json json_of(const VerificationResult& result, Json frames) {
  return {{"passed", result.passed()},
          {"frames", result.frames},
          {"different", result.different},
          {"not_expected", result.not_expected},
          {"missing", result.missing},
          {"problems", result.problems},
          {"differing_frames", std::move(frames)}};
}

std::string text_of(const VerificationResult& result) {
  const std::size_t equal = result.frames - result.different - result.not_expected;
  return fmt::format("{}: {} frames, {} as expected, {} different, {} not expected, {} missing",
                     result.passed() ? "passed" : "FAILED", result.frames, equal, result.different,
                     result.not_expected, result.missing);
}

int run_update(const VerifyOptions& options, OfflineSegmenter& segmenter, LiveLine& line,
               bool terminal) {
  const std::size_t frames = write_golden(recording::mcap_input(options.input), options.golden,
                                          segmenter, [&](std::size_t done) {
                                            if (terminal)
                                              line.show(std::to_string(done) + " frames");
                                          });
  line.erase();
  std::cout << options.golden << ": " << frames << " frames\n";
  return exit_done;
}

int run(const VerifyOptions& options) {
  const segmentation::Options segmentation = options_of(options.segmentation);
  OfflineSegmenter segmenter(segmentation, options.workers, options.unit.unit());
  const bool terminal = is_terminal(STDERR_FILENO);
  LiveLine line(std::cerr, live_columns(STDERR_FILENO));
  if (options.update) return run_update(options, segmenter, line, terminal);

  Json frames = Json::array();
  const VerificationResult result = verify(
      recording::mcap_input(options.input), options.golden, segmenter, options.tolerances,
      [&](const FrameDifference& difference) {
        line.erase();
        options.json ? frames.push_back(json_of(difference)) : print(difference);
      },
      [&](std::size_t done) {
        if (terminal) line.show(std::to_string(done) + " frames");
      });
  line.erase();
  for (const std::string& problem : result.problems) spdlog::warn("not read: {}", problem);
  if (result.frames == 0) {
    spdlog::error("{}: not one cloud was compared{}", options.input,
                  result.problems.empty() ? "" : ": " + result.problems.front());
  }
  std::cout << (options.json ? one_line(json_of(result, std::move(frames))) : text_of(result))
            << '\n';
  return result.passed() ? exit_done : exit_failed;
}

}  // namespace

void add_verify_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<VerifyOptions>();
  CLI::App* command = app.add_subcommand(
      "verify", "Segments a recording's clouds, and compares with labels and segments on file");
  command->add_option("INPUT", options->input, "recording with clouds (.mcap, .mcap?topic=T)")
      ->required();
  command
      ->add_option("--expect", options->golden,
                   "recording with the labels and segments that are right;\n"
                   "may be INPUT")
      ->required();
  auto* update = command->add_flag("--update", options->update,
                                   "write what is found now to the --expect file");
  command
      ->add_option("--tolerance-points", options->tolerances.points_share,
                   "share of a frame's points that may have another label; 0")
      ->check(CLI::Range(0.0, 1.0))
      ->excludes(update);
  command
      ->add_option("--tolerance-m", options->tolerances.distance_m,
                   "metres by which a centroid or a box may be off; 0")
      ->check(CLI::NonNegativeNumber)
      ->excludes(update);
  command->add_option("--workers", options->workers, "frames at a time; the number of cores")
      ->check(CLI::Range(1, 64));
  command->add_flag("--json", options->json, "one JSON object: passed, frames, different, ...");
  add_unit_option(*command, options->unit);
  add_segmentation_options(*command, options->segmentation);
  command->footer(
      "Examples:\n"
      "  cleave verify run.mcap --expect golden.mcap --update    once, and look at it\n"
      "  cleave verify run.mcap --expect golden.mcap             ever after, in CI\n"
      "\n"
      "No camera, daemon or shared memory is needed. Labels do not depend on the machine or on\n"
      "--workers, so the comparison is exact unless a tolerance is given.\n"
      "Exit codes: 0 as expected, 1 not, or a file is damaged.");
  command->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace cleave::workbench
