// SPDX-License-Identifier: BSD-3-Clause
// `cleave info --json` leaves nothing out.
#include "cleave/commands/info_command.hpp"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

#include "console/json.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/recording/mcap/mcap_bytes.hpp"
#include "tests/unit/recording/recording_files.hpp"

namespace cleave::client {
namespace {

TEST(InfoCommand, ListsEveryMetadataRecordAlsoWhereSeveralHaveOneName) {
  const tests::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "a.mcap";
  recording::McapBytes bytes = recording::begun_file();
  bytes.metadata("notes").metadata("notes").message(1, 1).footer();
  recording::write_all(file, bytes.bytes());
  CLI::App app;
  Action action;
  add_info_command(app, action);
  app.parse({"--json", file.string(), "info"});  // the last word first

  testing::internal::CaptureStdout();
  EXPECT_EQ(action(), exit_done);
  const Json info = Json::parse(testing::internal::GetCapturedStdout());

  EXPECT_EQ(info["metadata_count"], 2);
  EXPECT_EQ(info["metadata"], (Json{{"notes", {{"key", "value"}}}}));
  const Json record = {{"name", "notes"}, {"entries", {{"key", "value"}}}};
  EXPECT_EQ(info["metadata_records"], Json::array({record, record}));
}

}  // namespace
}  // namespace cleave::client
