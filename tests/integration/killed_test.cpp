// SPDX-License-Identifier: BSD-3-Clause
// kill -9 of whatever uses shared memory, at random moments: the stream comes back each time, and
// no chunk is lost for good.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <random>
#include <string>
#include <thread>

#include "tests/integration/support/daemons.hpp"
#include "tests/integration/support/monitor.hpp"
#include "tests/integration/support/roudi_fixture.hpp"
#include "tests/integration/support/small_clouds.hpp"

namespace cleave::test {
namespace {

TEST(Killed, ProcessesLoseNoChunkForGoodAndTheStreamComesBack) {
  const char* const wanted = std::getenv("CLEAVE_KILLS");
  const int kills = wanted != nullptr ? std::stoi(wanted) : 20;
  const RouDi roudi;
  const TemporaryFolder folder;
  write_pcd(folder.path() / "a.pcd", 80, 60);
  const Daemons daemons(17, true);
  Monitor monitor(17, "camera");
  std::optional<Process> segmenter(daemons.segmenter());
  const auto camera = [&] {
    return daemons.grabber("pcd:" + folder.path().string(), {"--loop", "--fps", "120"});
  };
  const auto reader = [&] { return daemons.run("label_hasher", {"camera", "100000"}); };
  std::optional<Process> grabber(camera()), client(reader());
  std::mt19937 random(1);
  for (int i = 0; i < kills; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(random() % 700));
    // Of three kills one hits the segmenter, which takes longest to start.
    std::optional<Process>& victim = i % 3 == 0 ? segmenter : i % 3 == 1 ? grabber : client;
    victim->signal(SIGKILL);
    (void)victim->wait();
    victim.reset();
    victim.emplace(i % 3 == 0 ? daemons.segmenter() : i % 3 == 1 ? camera() : reader());
  }
  monitor.poll();
  const std::size_t wanted_lists = monitor.lists().size() + 30;
  EXPECT_TRUE(eventually([&] {
    monitor.poll();
    return monitor.lists().size() >= wanted_lists;
  })) << segmenter->log()
      << grabber->log();
  client.reset();
  grabber->signal(SIGTERM);
  EXPECT_EQ(grabber->wait(), 0) << grabber->log();
  segmenter->signal(SIGTERM);
  EXPECT_EQ(segmenter->wait(), 0) << segmenter->log();

  std::string used;
  EXPECT_TRUE(eventually(
      [&] {
        (void)daemons.run("cleave", {"list"}).wait();  // signs off the dead, as any that joins
        Process asked = daemons.run("chunks_in_use", {});
        EXPECT_EQ(asked.wait(), 0) << asked.log();
        return (used = asked.output()) == "0\n";
      },
      std::chrono::seconds(20)));
  std::cout << kills << " kills, chunks lost: " << used;
}

}  // namespace
}  // namespace cleave::test
