#include "cleave/commands/info_command.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <map>
#include <memory>

#include "cleave/console/json.hpp"
#include "cleave/console/table.hpp"
#include "recording/mcap/reader.hpp"

namespace cleave::client {
namespace {

using recording::McapReader;

struct InfoOptions {
  std::string input;
  bool json = false;
};

struct TopicInfo {
  std::string schema;
  std::uint64_t messages = 0;
  std::uint64_t bytes = 0;
};

// Reads every message: what is said of a file is then true of its data, too.
std::map<std::string, TopicInfo> topics_of(McapReader& reader) {
  std::map<std::string, TopicInfo> topics;
  while (const auto message = reader.next()) {
    TopicInfo& topic = topics[message->channel->topic];
    topic.schema = message->schema->name;
    topic.messages += 1;
    topic.bytes += message->data.size();
  }
  return topics;
}

double duration_s(const McapReader& reader) {
  return static_cast<double>(reader.end_ns() - reader.start_ns()) / 1e9;
}

Json json_of(const McapReader& reader, const std::map<std::string, TopicInfo>& topics) {
  Json list = Json::array();
  for (const auto& [name, topic] : topics) {
    list.push_back({{"topic", name},
                    {"schema", topic.schema},
                    {"messages", topic.messages},
                    {"bytes", topic.bytes}});
  }
  Json metadata = Json::object();
  for (const auto& record : reader.contents().metadata) metadata[record.name] = record.entries;
  return {{"bytes", reader.size_bytes()},
          {"complete", reader.contents().closed},
          {"start_ns", reader.start_ns()},
          {"duration_s", duration_s(reader)},
          {"chunks", reader.contents().chunks.size()},
          {"topics", list},
          {"metadata", metadata},
          {"problems", reader.problems()}};
}

std::string text_of(const McapReader& reader, const std::map<std::string, TopicInfo>& topics) {
  std::string text = fmt::format("{:.1f} MB in {} chunks, {:.1f} s{}\n\n",
                                 static_cast<double>(reader.size_bytes()) / 1e6,
                                 reader.contents().chunks.size(), duration_s(reader),
                                 reader.contents().closed ? "" : ", not complete: it has no index");
  Table table({{"TOPIC", Align::left},
               {"MESSAGES", Align::right},
               {"MB", Align::right},
               {"TYPE", Align::left}});
  for (const auto& [name, topic] : topics) {
    table.add_row({name, std::to_string(topic.messages),
                   fmt::format("{:.1f}", static_cast<double>(topic.bytes) / 1e6), topic.schema});
  }
  text += table.to_string();
  for (const auto& record : reader.contents().metadata) {
    text += '\n' + printable(record.name) + '\n';
    for (const auto& [key, value] : record.entries) {
      text += "  " + printable(key) + ": " + printable(value) + '\n';
    }
  }
  return text;
}

int run(const InfoOptions& options) {
  McapReader reader(options.input);
  const std::map<std::string, TopicInfo> topics = topics_of(reader);
  if (options.json) {
    std::cout << one_line(json_of(reader, topics)) << '\n';
  } else {
    std::cout << text_of(reader, topics);
  }
  for (const std::string& problem : reader.problems()) spdlog::warn("damaged: {}", problem);
  if (reader.problems().empty()) return exit_done;
  spdlog::warn("`cleave recover {} OUTPUT` keeps what is intact", options.input);
  return exit_failed;
}

}  // namespace

void add_info_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<InfoOptions>();
  CLI::App* command = app.add_subcommand("info", "What a recording holds, and whether it is whole");
  command->add_option("INPUT", options->input, "MCAP file")->required();
  command->add_flag(
      "--json", options->json,
      "one JSON object: bytes, complete, duration_s, topics, metadata, problems, ...");
  command->footer(
      "Examples:\n"
      "  cleave info run.mcap\n"
      "  cleave info run.mcap --json | jq '.topics[].messages'\n"
      "\n"
      "Reads every message and checks every checksum. Sizes by topic are those before "
      "compression.\n"
      "Exit code 1: the file is damaged.");
  command->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace cleave::client
