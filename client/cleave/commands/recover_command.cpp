// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/commands/recover_command.hpp"

#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "recording/mcap/recover.hpp"
#include "recording/sources/frame_sink.hpp"

namespace cleave::client {
namespace {

struct RecoverOptions {
  std::string damaged;
  std::string output;
};

int run(const RecoverOptions& options) {
  recording::refuse_existing(options.output);
  const recording::Recovery recovery = recording::recover(options.damaged, options.output);
  const std::vector<std::string>& named = recovery.problems.texts();
  for (const std::string& problem : named) spdlog::warn("damaged: {}", problem);
  if (const std::uint64_t more = recovery.problems.count() - named.size(); more > 0) {
    spdlog::warn("damaged: {} more places", more);
  }
  const std::uint64_t kept = recovery.messages + recovery.attachments + recovery.metadata;
  if (kept == 0 && !recovery.problems.empty()) {
    std::filesystem::remove(options.output);
    throw std::runtime_error(options.damaged + ": no message of it is intact; nothing was written");
  }
  std::cout << options.output << ": " << recovery.messages << " messages, " << recovery.attachments
            << " attachments, " << recovery.metadata << " metadata records, "
            << recovery.problems.count() << " damaged places left out\n";
  return exit_done;
}

}  // namespace

void add_recover_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<RecoverOptions>();
  CLI::App* command =
      app.add_subcommand("recover", "Makes a whole recording of what is left of a damaged one");
  command->add_option("DAMAGED", options->damaged, "MCAP file, cut off or damaged")->required();
  command->add_option("OUTPUT", options->output, "MCAP file to write")->required();
  command->footer(
      "Examples:\n"
      "  cleave recover cut_off.mcap whole.mcap\n"
      "\n"
      "Every chunk whose checksum is right is kept, with attachments and metadata. A recorder\n"
      "that was killed, or that met a full disk, loses at most the last chunk: a second, or\n"
      "4 MB before compression.");
  command->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace cleave::client
