// SPDX-License-Identifier: BSD-3-Clause
// MCAP's own reader, and Foxglove's own decoders, on our recordings.
#include <gtest/gtest.h>

#include "recording/frames/frame_writer.hpp"
#include "recording/mcap/reader.hpp"
#include "recording/mcap/recover.hpp"
#include "tests/integration/support/process.hpp"
#include "tests/interop/npm_packages.hpp"
#include "tests/support/data_folder.hpp"
#include "tests/unit/recording/recording_files.hpp"

namespace cleave::test {
namespace {

namespace fs = std::filesystem;

class McapInterop : public testing::Test {
 protected:
  void SetUp() override {
    install_npm_packages(CLEAVE_MCAP_INTEROP, folder_);
    for (const char* const script : {"read_all.mjs", "compare_records.mjs"}) {
      fs::copy_file(fs::path(CLEAVE_MCAP_INTEROP) / script, folder_ / script,
                    fs::copy_options::overwrite_existing);
    }
  }
  [[nodiscard]] Process read(const fs::path& file) const {
    return Process({"/usr/bin/env", "node", (folder_ / "read_all.mjs").string(), file.string()});
  }
  // Every file of a folder with the list of its records.
  [[nodiscard]] Process compare(const fs::path& folder, const fs::path& lists) const {
    return Process({"/usr/bin/env", "node", (folder_ / "compare_records.mjs").string(),
                    folder.string(), lists.string()});
  }

  const fs::path folder_ = CLEAVE_MCAP_MODULES;
  const TemporaryFolder files_;
};

TEST_F(McapInterop, ReadsEveryMessageOfARecordingOf300FramesAndItsCrcs) {
  const fs::path file = files_.path() / "a.mcap";
  recording::write_frames(file, 300, 100'000);
  Process reader = read(file);
  EXPECT_EQ(reader.wait(), 0) << reader.log();
  for (const char* const topic : {"depth/image", "depth/camera_info", "cloud", "labels/image",
                                  "labels", "segments", "segments/boxes"}) {
    const std::string counted = "\"cleave/camera/" + std::string(topic) + "\":300";
    EXPECT_NE(reader.output().find(counted), std::string::npos) << counted << reader.output();
  }
}

TEST_F(McapInterop, ReadsCloudsWithoutACameraAndMetadata) {
  const fs::path file = files_.path() / "a.mcap";
  recording::FrameWriter writer(file);
  for (std::uint64_t id = 1; id <= 3; ++id) {
    writer.write({static_cast<std::int64_t>(id), recording::free_cloud(id)});
  }
  writer.add_metadata({"cleave", {{"dropped cloud", "0"}}});
  writer.close();
  Process reader = read(file);
  EXPECT_EQ(reader.wait(), 0) << reader.log();
  EXPECT_NE(reader.output().find("\"cleave/camera/points\":3"), std::string::npos)
      << reader.output();
}

TEST_F(McapInterop, NoticesAChangedByte) {
  const fs::path file = files_.path() / "a.mcap";
  recording::write_frames(file, 20, 10'000);
  const recording::ChunkPlace chunk = recording::McapReader(file).contents().chunks.at(2);
  recording::Bytes bytes = recording::read_all(file);
  bytes[chunk.offset + recording::record_prefix_bytes + 24] ^= std::byte{1};  // the chunk's CRC
  recording::write_all(file, bytes);
  Process reader = read(file);
  EXPECT_NE(reader.wait(), 0) << reader.output();
}

TEST_F(McapInterop, FindsEveryRecordOfTheConformanceFilesInWhatRecoverMadeOfThem) {
  const auto conformance = tests::find_data("mcap-conformance");
  if (!conformance) GTEST_SKIP() << "mcap-conformance is absent from the data folder";
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(*conformance)) {
    if (entry.path().extension() != ".mcap") continue;
    (void)recording::recover(entry.path(), files_.path() / entry.path().filename());
    ++files;
  }
  Process comparison = compare(files_.path(), *conformance);
  EXPECT_EQ(comparison.wait(std::chrono::minutes(2)), 0) << comparison.log();
  EXPECT_EQ(comparison.output(), std::to_string(files) + " files are equal\n");
}

}  // namespace
}  // namespace cleave::test
