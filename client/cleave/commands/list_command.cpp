// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/commands/list_command.hpp"

#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <map>
#include <memory>
#include <vector>

#include "cleave/stream/live_options.hpp"
#include "console/json.hpp"
#include "console/table.hpp"
#include "libcleave/discovery.hpp"

namespace cleave::client {
namespace {

struct ListOptions {
  LiveOptions live;
  bool json = false;
};

struct TopicUse {
  std::string type;
  std::vector<std::string> writers;
  std::vector<std::string> readers;
};

constexpr std::chrono::milliseconds list_discovery_time{1000};

std::map<std::string, TopicUse> by_topic(const std::vector<Endpoint>& endpoints) {
  std::map<std::string, TopicUse> topics;
  for (const Endpoint& endpoint : endpoints) {
    TopicUse& use = topics[endpoint.topic];
    use.type = endpoint.type;
    (endpoint.writes ? use.writers : use.readers)
        .push_back(endpoint.process.empty() ? "unnamed process" : endpoint.process);
  }
  return topics;
}

void print_table(const std::map<std::string, TopicUse>& topics) {
  Table table({{"topic", Align::left},
               {"type", Align::left},
               {"writers", Align::left},
               {"readers", Align::left}});
  for (const auto& [topic, use] : topics) {
    table.add_row({topic, use.type, fmt::format("{}", fmt::join(use.writers, ", ")),
                   fmt::format("{}", fmt::join(use.readers, ", "))});
  }
  std::cout << table.to_string();
}

void print_json(const std::map<std::string, TopicUse>& topics) {
  Json array = Json::array();
  for (const auto& [topic, use] : topics) {
    array.push_back(
        {{"topic", topic}, {"type", use.type}, {"writers", use.writers}, {"readers", use.readers}});
  }
  std::cout << one_line({{"topics", array}}) << '\n';
}

int run(const ListOptions& options) {
  Stream stream(stream_options(options.live));
  const auto topics = by_topic(discover(stream, list_discovery_time));
  if (options.json) {
    print_json(topics);
  } else if (topics.empty()) {
    std::cerr << fmt::format(
        "Nobody publishes or reads cleave/... topics on domain {}.\n"
        "Start ./service/demo, or {}.\n",
        stream.options().domain, elsewhere);
  } else {
    print_table(topics);
  }
  return exit_done;
}

}  // namespace

void add_list_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<ListOptions>();
  CLI::App* command = app.add_subcommand("list", "Topics of the stream, their writers and readers");
  add_stream_options(*command, options->live);
  command->add_flag("--json", options->json, "one JSON object: topics [topic, type, writers, ...]");
  command->footer(
      "Examples:\n"
      "  cleave list\n"
      "  cleave list --domain 3 --json");
  command->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace cleave::client
