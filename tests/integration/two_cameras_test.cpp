// SPDX-License-Identifier: BSD-3-Clause
// Several cameras, one daemon.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>

#include "libcleave/reader.hpp"
#include "tests/integration/support/daemons.hpp"

namespace cleave::test {
namespace {

TEST(TwoCameras, AreSegmentedByOneDaemonEachInOrderAndUnderItsOwnName) {
  constexpr std::size_t frames = 15;
  const Daemons daemons(24, false);
  const TemporaryFolder folder;
  const std::string config = (folder.path() / "segmenter.yaml").string();
  std::ofstream(config) << "sensors: [left, right]\nmode: lossless\n";
  Stream stream(StreamOptions{24, false, "lo"});
  std::map<std::string, Reader<SegmentList>> readers;
  std::map<std::string, std::vector<std::uint64_t>> frame_ids;
  for (const char* sensor : {"left", "right"}) {
    readers.try_emplace(sensor, stream, sensor, ReaderDepth{static_cast<int>(frames)});
  }
  Process segmenter = daemons.run("cleave-segmenter", {"--config", config, "--no-shared-memory"});
  ASSERT_TRUE(segmenter.logs("segmenting sensor 'right'")) << segmenter.log();

  const std::vector<std::string> options = {"--lossless", "--frames", std::to_string(frames),
                                            "--sensor"};
  std::vector<Process> grabbers;
  for (const char* sensor : {"left", "right"}) {
    auto own = options;
    own.emplace_back(sensor);
    grabbers.push_back(daemons.grabber("synthetic:simple", own));
  }

  for (auto& [sensor, reader] : readers) {
    std::vector<std::uint64_t>& ids = frame_ids[sensor];
    EXPECT_TRUE(eventually([&] {
      while (const auto list = reader.take()) {
        EXPECT_EQ(name_of((*list)->header.sensor), sensor);
        ids.push_back((*list)->header.frame_id);
      }
      return ids.size() >= frames;
    })) << segmenter.log();
    EXPECT_TRUE(std::is_sorted(ids.begin(), ids.end()));
  }
  for (Process& grabber : grabbers) EXPECT_EQ(grabber.wait(), 0) << grabber.log();
}

}  // namespace
}  // namespace cleave::test
