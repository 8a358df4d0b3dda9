// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/commands/info_command.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <utility>

#include "console/json.hpp"
#include "console/live_line.hpp"
#include "console/table.hpp"
#include "console/terminal.hpp"
#include "recording/mcap/reader.hpp"
#include "recording/ros/topic_survey.hpp"

namespace cleave::client {
namespace {

using recording::McapReader;

struct InfoOptions {
  std::string input;
  bool json = false;
};

struct TopicInfo {
  recording::ros::TopicUse use;
  std::uint64_t bytes = 0;
};

struct Totals {
  std::map<std::string, TopicInfo> topics;
  recording::ros::TopicSurvey survey;
  std::uint64_t messages = 0;
  std::uint64_t start_ns = 0;  // of the first message in time, and of the last
  std::uint64_t end_ns = 0;
};

void add(Totals& totals, const recording::Message& message) {
  totals.survey.add(message);
  totals.topics[message.channel->topic].bytes += message.data.size();
  const std::uint64_t log_ns = message.times.log_ns;
  totals.start_ns = totals.messages == 0 ? log_ns : std::min(totals.start_ns, log_ns);
  totals.end_ns = std::max(totals.end_ns, log_ns);
  totals.messages += 1;
}

// Reads every message: what is said of a file is then true of its data, too.
Totals read_all(McapReader& reader) {
  Totals totals;
  const bool terminal = is_terminal(STDERR_FILENO);
  LiveLine line(std::cerr, live_columns(STDERR_FILENO));
  std::uint64_t shown_percent = 0;
  while (const auto message = reader.next()) {
    add(totals, *message);
    const std::uint64_t percent = 100 * message->offset / reader.size_bytes();
    if (terminal && percent > std::exchange(shown_percent, percent)) {
      line.show(fmt::format("{} % read", percent));
    }
  }
  line.erase();
  reader.check_attachments();
  reader.check_totals(totals.messages);
  for (auto& use : totals.survey.topics()) totals.topics[use.topic].use = std::move(use);
  return totals;
}

// "yes", "yes; ..." or "no: ..."
std::string verdict_of(const recording::ros::TopicUse& use) {
  if (!use.usable()) return "no: " + use.why;
  return use.why.empty() ? "yes" : "yes; " + use.why;
}

double duration_s(const Totals& totals) {
  return static_cast<double>(totals.end_ns - totals.start_ns) / 1e9;
}

bool is_whole(const McapReader& reader) {
  return reader.contents().closed && reader.problems().empty();
}

std::size_t chunks_of(const recording::Contents& contents) {
  return static_cast<std::size_t>(
      std::ranges::count(contents.chunks, false, &recording::ChunkPlace::loose));
}

Json json_of(const std::map<std::string, TopicInfo>& topics) {
  Json list = Json::array();
  for (const auto& [name, topic] : topics) {
    list.push_back({{"topic", name},
                    {"schema", topic.use.type},
                    {"encoding", topic.use.message_encoding},
                    {"messages", topic.use.messages},
                    {"bytes", topic.bytes},
                    {"segmentable", topic.use.usable()},
                    {"why", topic.use.why}});
  }
  return list;
}

Json json_of(const std::vector<recording::Attachment>& attachments) {
  Json list = Json::array();
  for (const auto& attachment : attachments) {
    list.push_back({{"name", attachment.name},
                    {"media_type", attachment.media_type},
                    {"bytes", attachment.data_bytes},
                    {"log_ns", attachment.log_ns},
                    {"create_ns", attachment.create_ns}});
  }
  return list;
}

// The counts have the names that the format's own statistics have.
Json json_of(const McapReader& reader, const Totals& totals) {
  const recording::Contents& contents = reader.contents();
  Json metadata = Json::object();
  Json records = Json::array();
  for (const auto& record : contents.metadata) {
    metadata[record.name] = record.entries;  // of several records of one name, the last
    records.push_back({{"name", record.name}, {"entries", record.entries}});
  }
  return {{"bytes", reader.size_bytes()},
          {"complete", is_whole(reader)},
          {"closed", contents.closed},
          {"start_ns", totals.start_ns},
          {"duration_s", duration_s(totals)},
          {"chunks", chunks_of(contents)},
          {"message_count", totals.messages},
          {"schema_count", reader.schemas().size()},
          {"channel_count", reader.channels().size()},
          {"attachment_count", contents.attachments.size()},
          {"metadata_count", contents.metadata.size()},
          {"private_records", contents.private_records},
          {"unknown_records", contents.unknown_records},
          {"topics", json_of(totals.topics)},
          {"attachments", json_of(contents.attachments)},
          {"metadata", metadata},
          {"metadata_records", records},
          {"problems", reader.problems()}};
}

std::string summary_of(const McapReader& reader, const Totals& totals) {
  const recording::Contents& contents = reader.contents();
  std::string text = fmt::format("{:.1f} MB in {} chunks, {} messages in {:.1f} s",
                                 static_cast<double>(reader.size_bytes()) / 1e6,
                                 chunks_of(contents), totals.messages, duration_s(totals));
  if (contents.private_records > 0) {
    text += fmt::format(", {} records of an application's own", contents.private_records);
  }
  if (contents.unknown_records > 0) {
    text += fmt::format(", {} records of unknown kinds", contents.unknown_records);
  }
  if (!contents.closed) text += ", not closed: its recorder was cut off, or is still writing";
  return text + "\n\n";
}

std::string text_of(const McapReader& reader, const Totals& totals) {
  std::string text = summary_of(reader, totals);
  Table table({{"TOPIC", Align::left},
               {"MESSAGES", Align::right},
               {"MB", Align::right},
               {"TYPE", Align::left},
               {"ENCODING", Align::left},
               {"CAN BE SEGMENTED", Align::left}});
  for (const auto& [name, topic] : totals.topics) {
    table.add_row({printable(name), std::to_string(topic.use.messages),
                   fmt::format("{:.1f}", static_cast<double>(topic.bytes) / 1e6),
                   topic.use.type.empty() ? "no schema" : printable(topic.use.type),
                   printable(topic.use.message_encoding), printable(verdict_of(topic.use))});
  }
  text += table.to_string();
  for (const auto& attachment : reader.contents().attachments) {
    text += fmt::format("\nattachment {} ({}, {} bytes)\n", printable(attachment.name),
                        printable(attachment.media_type), attachment.data_bytes);
  }
  for (const auto& record : reader.contents().metadata) {
    text += '\n' + printable(record.name) + '\n';
    for (const auto& [key, value] : record.entries) {
      text += "  " + printable(key) + ": " + printable(value) + '\n';
    }
  }
  return text;
}

int run(const InfoOptions& options) {
  McapReader reader(options.input, recording::Order::file);
  const Totals totals = read_all(reader);
  if (options.json) {
    std::cout << one_line(json_of(reader, totals)) << '\n';
  } else {
    std::cout << text_of(reader, totals);
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
      "one JSON object: bytes, complete, duration_s, message_count, topics, attachments, "
      "metadata, problems, ...");
  command->footer(
      "Examples:\n"
      "  cleave info run.mcap\n"
      "  cleave info run.mcap --json | jq '.topics[].messages'\n"
      "\n"
      "Reads every message and checks every checksum; `complete` is said of a file that its\n"
      "recorder closed and of which all was read. Sizes by topic are those before compression.\n"
      "Of every topic it says whether its messages can be clouds for convert, verify, segment and\n"
      "cleave-grabber (FILE?topic=TOPIC names one), or why not.\n"
      "In JSON, `metadata` has the entries by the record's name, the last record's where several\n"
      "have one name; `metadata_records` lists them all.\n"
      "Exit code 1: the file is damaged.");
  command->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace cleave::client
