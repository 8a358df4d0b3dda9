// SPDX-License-Identifier: BSD-3-Clause
// Each reason for which there is no shared memory is named, and segments flow all the same.
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "tests/integration/support/daemons.hpp"
#include "tests/integration/support/monitor.hpp"
#include "tests/integration/support/roudi_fixture.hpp"
#include "tests/integration/support/small_clouds.hpp"

namespace cleave::test {
namespace {

class NoSharedMemory : public testing::Test {
 protected:
  NoSharedMemory() {
    write_pcd(folder_.path() / "a.pcd", 80, 60);
    std::filesystem::permissions(folder_.path(), std::filesystem::perms(0755));
  }

  std::filesystem::path pools(const std::string& text) const {
    std::ofstream(folder_.path() / "roudi.toml") << "[general]\nversion = 1\n[[segment]]\n" << text;
    return folder_.path() / "roudi.toml";
  }

  // The reason is in the log, in the status and in what `cleave status` shows; clouds arrive.
  void expect_network_because(const std::string& reason) {
    Process segmenter = daemons_.segmenter();
    ASSERT_TRUE(segmenter.logs("ready")) << segmenter.log();
    const Process camera = daemons_.grabber("pcd:" + folder_.path().string(), {"--loop"});
    EXPECT_NE(segmenter.log().find(reason), std::string::npos) << segmenter.log();
    ASSERT_TRUE(eventually([&] {
      monitor_.poll();
      return monitor_.status("segmenter/camera").frames_out > 3;
    })) << segmenter.log()
        << camera.log();
    const NodeReport status = monitor_.status("segmenter/camera");
    EXPECT_EQ(status.transport_in_force, Transport::network);
    EXPECT_NE(status.transport_reason.find(reason), std::string::npos) << status.transport_reason;
    Process shown = daemons_.run("cleave", {"status"});
    EXPECT_EQ(shown.wait(), 0) << shown.log();
    EXPECT_NE(shown.output().find(reason), std::string::npos) << shown.output();
    EXPECT_TRUE(segmenter.running());
  }

  TemporaryFolder folder_;
  Daemons daemons_{14, true};
  Monitor monitor_{14, "camera"};
};

constexpr char small_pool[] = "[[segment.mempool]]\nsize = 16384\ncount = 1000\n";

TEST_F(NoSharedMemory, BecauseThePoolsHaveNoChunkForACloud) {
  const RouDi roudi(pools(small_pool));
  expect_network_because("RouDi's pools have no chunks of 3686");
}

TEST_F(NoSharedMemory, BecauseRouDiRunsAsAnotherUser) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root may start RouDi as another user";
  const RouDi roudi(pools(small_pool),
                    {"/usr/bin/setpriv", "--reuid=nobody", "--regid=nogroup", "--clear-groups"});
  expect_network_because("RouDi runs as user 'nobody', which keeps user 'root' out");
}

TEST_F(NoSharedMemory, BecauseThereIsNoRoomForRouDi) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root may mount a smaller /dev/shm";
  const RouDiLock nobody_starts_one;
  Process list({"/usr/bin/unshare", "--mount", "sh", "-c",
                "mount -t tmpfs -o size=16m small /dev/shm && exec \"$0\" list", program("cleave")},
               {{"CLEAVE_DOMAIN", "14"}});
  EXPECT_TRUE(list.logs("/dev/shm has room for 16 of the 272 MB")) << list.log() << list.output();
}

}  // namespace
}  // namespace cleave::test
