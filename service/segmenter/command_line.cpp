// SPDX-License-Identifier: BSD-3-Clause
#include "segmenter/command_line.hpp"

#include <CLI/CLI.hpp>

#include "config/segmenter_config.hpp"
#include "idl/topics.hpp"
#include "libcleave/process/exit_codes.hpp"

namespace cleave::service {
namespace {

constexpr char examples[] =
    "Examples:\n"
    "  cleave-segmenter --config config/segmenter.yaml\n"
    "  cleave-segmenter --config config/segmenter.yaml --sensor wrist --workers 2\n"
    "  cleave-segmenter --config config/segmenter.yaml --lossless   (the grabber, too)\n"
    "Ends with 0 after SIGTERM or Ctrl-C, 1 when something fails, 2 for wrong usage.\n";

}  // namespace

std::variant<CommandLine, int> parse_command_line(int count, const char* const* arguments) {
  CommandLine line;
  CLI::App app("Segments the clouds of depth cameras and publishes label maps and segment lists.",
               "cleave-segmenter");
  app.footer(examples);
  app.set_version_flag("--version", version_text(CLEAVE_VERSION));
  app.add_option("--config", line.config_file,
                 "Configuration file (YAML); else segmenter.yaml of the installation")
      ->type_name("FILE");
  app.add_option("--workers", line.workers, "Frames segmented at a time, for each sensor")
      ->check(CLI::Range(std::uint32_t{1}, config::max_workers));
  app.add_option("--sensor", line.sensor, "This sensor, in place of the file's")->type_name("NAME");
  app.add_flag("--lossless", line.lossless,
               "Drop no frame: the grabber waits for the segment lists (its --lossless)");
  app.add_flag("--no-shared-memory", line.no_shared_memory,
               "Copy clouds and label maps over loopback");
  try {
    app.parse(count, arguments);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_done : exit_wrong_usage;
  }
  return line;
}

}  // namespace cleave::service
