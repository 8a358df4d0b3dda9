// SPDX-License-Identifier: BSD-3-Clause
// Another vendor's DDS reads our segment lists from the same contract.
#include <gtest/gtest.h>

#include "tests/integration/support/daemons.hpp"
#include "tests/integration/support/small_clouds.hpp"

namespace cleave::test {
namespace {

TEST(FastDds, ReceivesSegmentListsFromTheRunningDaemon) {
  const TemporaryFolder folder;
  write_pcd(folder.path() / "a.pcd", 80, 60);
  const Daemons daemons(14, false);
  Process subscriber = daemons.run("fast_dds_subscriber", {"14", "camera", "20"});
  Process segmenter = daemons.segmenter();
  Process camera = daemons.grabber("pcd:" + folder.path().string(), {"--loop"});
  EXPECT_EQ(subscriber.wait(), 0) << subscriber.log() << segmenter.log() << camera.log();
  EXPECT_EQ(subscriber.output().find("camera frame "), 0U) << subscriber.output();
  EXPECT_NE(subscriber.output().find("segments 4"), std::string::npos) << subscriber.output();
}

}  // namespace
}  // namespace cleave::test
