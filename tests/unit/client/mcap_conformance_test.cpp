// SPDX-License-Identifier: BSD-3-Clause
// The format's own conformance files, each with a list of its records: what `cleave info` counts
// and what `cleave recover` writes.
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cleave/commands/info_command.hpp"
#include "cleave/commands/recover_command.hpp"
#include "recording/mcap/reader.hpp"
#include "tests/support/data_folder.hpp"
#include "tests/support/temporary_folder.hpp"

namespace cleave::client {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// What the command prints; its exit code must be 0.
std::string output_of(std::vector<std::string> words) {
  CLI::App app;
  Action action;
  add_info_command(app, action);
  add_recover_command(app, action);
  std::reverse(words.begin(), words.end());  // CLI11 takes them from the back
  app.parse(words);
  std::ostringstream output;
  std::streambuf* const before = std::cout.rdbuf(output.rdbuf());
  const int code = action();
  std::cout.rdbuf(before);
  EXPECT_EQ(code, 0);
  return output.str();
}

struct Record {
  std::string type;
  std::map<std::string, json> fields;
};

// Messages, attachments and metadata, in the order of the file.
std::vector<Record> records_of(const fs::path& list) {
  std::ifstream stream(list);
  const json listed = json::parse(stream);
  std::vector<Record> records;
  for (const json& record : listed.at("records")) {
    const auto type = record.at("type").get<std::string>();
    if (type != "Message" && type != "Attachment" && type != "Metadata") continue;
    Record& added = records.emplace_back(Record{type, {}});
    for (const json& field : record.at("fields")) added.fields[field.at(0)] = field.at(1);
  }
  return records;
}

std::size_t count(const std::vector<Record>& records, const char* type) {
  return static_cast<std::size_t>(std::ranges::count(records, type, &Record::type));
}

std::string number(const json& field) {
  return field.get<std::string>();
}

recording::Bytes bytes(const json& field) {
  recording::Bytes bytes;
  for (const json& byte : field) bytes.push_back(std::byte(std::stoi(byte.get<std::string>())));
  return bytes;
}

// Their names begin with what they hold; the letters behind are options of their writer.
std::vector<fs::path> files_of(const std::string& scenario) {
  std::vector<fs::path> files;
  if (const auto folder = tests::find_data("mcap-conformance")) {
    for (const auto& entry : fs::directory_iterator(*folder)) {
      const std::string name = entry.path().stem().string();
      if (entry.path().extension() == ".mcap" && name.substr(0, name.find('-')) == scenario) {
        files.push_back(entry.path());
      }
    }
  }
  std::ranges::sort(files);
  return files;
}

class McapConformance : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (files_.empty()) GTEST_SKIP() << "mcap-conformance is absent from the data folder";
  }
  static fs::path list_of(fs::path file) { return file.replace_extension(".json"); }

  const std::vector<fs::path> files_ = files_of(GetParam());
  const tests::TemporaryFolder folder_;
};

TEST_P(McapConformance, InfoCountsEveryRecordAndSaysThatTheFileIsWhole) {
  for (const fs::path& file : files_) {
    SCOPED_TRACE(file.filename().string());
    const std::vector<Record> expected = records_of(list_of(file));
    const json info = json::parse(output_of({"info", "--json", file.string()}));
    EXPECT_EQ(info.at("message_count"), count(expected, "Message"));
    EXPECT_EQ(info.at("attachment_count"), count(expected, "Attachment"));
    EXPECT_EQ(info.at("metadata_count"), count(expected, "Metadata"));
    EXPECT_EQ(info.at("attachments").size(), count(expected, "Attachment"));
    std::size_t by_topic = 0;
    for (const json& topic : info.at("topics")) by_topic += topic.at("messages").get<std::size_t>();
    EXPECT_EQ(by_topic, count(expected, "Message"));
    EXPECT_TRUE(info.at("complete"));
    EXPECT_TRUE(info.at("problems").empty()) << info.at("problems");
  }
}

TEST_P(McapConformance, RecoverWritesEveryRecord) {
  for (const fs::path& file : files_) {
    SCOPED_TRACE(file.filename().string());
    const fs::path copy = folder_.path() / file.filename();
    const std::string said = output_of({"recover", file.string(), copy.string()});
    EXPECT_NE(said.find(" 0 damaged places"), std::string::npos) << said;

    recording::McapReader reader(copy, recording::Order::file);
    std::size_t attachments = 0;
    std::size_t metadata = 0;
    for (const Record& expected : records_of(list_of(file))) {
      const auto& fields = expected.fields;
      if (expected.type == "Message") {
        const auto message = reader.next();
        ASSERT_TRUE(message);
        EXPECT_EQ(std::to_string(message->channel->id), number(fields.at("channel_id")));
        EXPECT_EQ(std::to_string(message->sequence), number(fields.at("sequence")));
        EXPECT_EQ(std::to_string(message->times.log_ns), number(fields.at("log_time")));
        EXPECT_EQ(std::to_string(message->times.publish_ns), number(fields.at("publish_time")));
        EXPECT_TRUE(std::ranges::equal(message->data, bytes(fields.at("data"))));
      } else if (expected.type == "Attachment") {
        const auto& attachment = reader.contents().attachments.at(attachments++);
        EXPECT_EQ(std::to_string(attachment.log_ns), number(fields.at("log_time")));
        EXPECT_EQ(std::to_string(attachment.create_ns), number(fields.at("create_time")));
        EXPECT_EQ(attachment.name, fields.at("name"));
        EXPECT_EQ(attachment.media_type, fields.at("media_type"));
        const recording::Bytes data = bytes(fields.at("data"));
        const recording::Bytes content = reader.read(attachment);
        const auto found = recording::ByteView(content)
                               .last(data.size() + sizeof(std::uint32_t))
                               .first(data.size());
        EXPECT_TRUE(std::ranges::equal(found, data));
      } else {
        const auto& record = reader.contents().metadata.at(metadata++);
        EXPECT_EQ(record.name, fields.at("name"));
        EXPECT_EQ(json(record.entries), fields.at("metadata"));
      }
    }
    EXPECT_FALSE(reader.next());
    EXPECT_EQ(reader.contents().attachments.size(), attachments);
    EXPECT_EQ(reader.contents().metadata.size(), metadata);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenarios, McapConformance,
                         testing::Values("NoData", "OneAttachment", "OneMessage", "OneMetadata",
                                         "OneSchemalessMessage", "TenMessages"),
                         [](const auto& info) { return std::string(info.param); });

// Files of scenarios that this test does not know would be passed over without a word.
TEST(McapConformanceFolder, HoldsNoOtherScenarios) {
  const auto folder = tests::find_data("mcap-conformance");
  if (!folder) GTEST_SKIP() << "mcap-conformance is absent from the data folder";
  std::ptrdiff_t all = std::ranges::count_if(
      fs::directory_iterator(*folder),
      [](const fs::directory_entry& entry) { return entry.path().extension() == ".mcap"; });
  for (const char* const scenario : {"NoData", "OneAttachment", "OneMessage", "OneMetadata",
                                     "OneSchemalessMessage", "TenMessages"}) {
    all -= static_cast<std::ptrdiff_t>(files_of(scenario).size());
  }
  EXPECT_EQ(all, 0);
}

}  // namespace
}  // namespace cleave::client
