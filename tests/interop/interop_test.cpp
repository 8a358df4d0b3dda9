// SPDX-License-Identifier: BSD-3-Clause
// Others' DDS reads what we publish, and publishes what we read, from the same contract.
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

// Over the network path: clouds of Fast DDS in, segment lists of ours out.
TEST(FastDds, PublishesCloudsThatAreSegmented) {
  const Daemons daemons(38, false);
  Process subscriber = daemons.run("fast_dds_subscriber", {"38", "camera", "10"});
  Process segmenter = daemons.segmenter();
  ASSERT_TRUE(segmenter.logs("ready")) << segmenter.log();
  Process camera = daemons.run("fast_dds_cloud_publisher", {"38", "camera", "20"});
  EXPECT_EQ(subscriber.wait(), 0) << subscriber.log() << segmenter.log() << camera.log();
  EXPECT_EQ(subscriber.output().find("camera frame "), 0U) << subscriber.output();
  EXPECT_NE(subscriber.output().find("segments 4"), std::string::npos) << subscriber.output();
  EXPECT_EQ(camera.wait(), 0) << camera.log();
}

TEST(CycloneInC, ReceivesSegmentListsAndStatusesFromTheRunningDaemons) {
  const TemporaryFolder folder;
  write_pcd(folder.path() / "a.pcd", 80, 60);
  const Daemons daemons(39, false);
  Process subscriber = daemons.run("cyclone_c_subscriber", {"39", "camera", "20"});
  Process segmenter = daemons.segmenter();
  Process camera = daemons.grabber("pcd:" + folder.path().string(), {"--loop"});
  EXPECT_EQ(subscriber.wait(), 0) << subscriber.log() << segmenter.log() << camera.log();
  for (const char* const line :
       {"camera frame ", "segments 4", "segmenter/camera of contract cleave_v1 is process ",
        "grabber/camera of contract cleave_v1 is process "}) {
    EXPECT_NE(subscriber.output().find(line), std::string::npos) << line << subscriber.output();
  }
}

}  // namespace
}  // namespace cleave::test
