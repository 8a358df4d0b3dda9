// SPDX-License-Identifier: BSD-3-Clause
// `service/demo` as its user starts it.
#include <grp.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "libcleave/roudi.hpp"
#include "tests/integration/support/daemons.hpp"
#include "tests/integration/support/roudi_fixture.hpp"

namespace cleave::test {
namespace {

class Demo : public testing::Test {
 protected:
  Process demo(std::vector<std::string> options) {
    options.insert(options.begin(), std::string(CLEAVE_SOURCE_DIR) + "/service/demo");
    return Process(options, {{"CLEAVE_DOMAIN", "9"}});
  }

  static std::size_t processes_of_domain_9() {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
      std::ifstream environment(entry.path() / "environ", std::ios::binary);
      std::string text((std::istreambuf_iterator<char>(environment)), {});
      if (text.find("CLEAVE_DOMAIN=9\0", 0, 16) != std::string::npos) ++count;
    }
    return count;
  }

  // RouDi's own, and its one segment, which has the name of the group that may write to it. Other
  // programs of the machine may have files there, too.
  static std::vector<std::string> shared_memory_of_roudi() {
    std::vector<std::string> names = {"iceoryx_mgmt", ::getgrgid(::getegid())->gr_name};
    std::erase_if(names, [](const std::string& name) {
      return !std::filesystem::exists(std::filesystem::path("/dev/shm") / name);
    });
    return names;
  }

  // The demo starts its own RouDi, so it takes the lock that RouDi's fixture takes.
  RouDiLock lock_;
};

void expect_all_accounted_for(const nlohmann::json& summary, std::uint64_t published) {
  EXPECT_EQ(summary["published"], published);
  EXPECT_EQ(summary["published"].get<std::uint64_t>(),
            summary["segmented"].get<std::uint64_t>() + summary["dropped"].get<std::uint64_t>() +
                summary["rejected"].get<std::uint64_t>());
}

TEST_F(Demo, Segments60FramesOfTheSyntheticCameraWithoutACopyAndCleansUp) {
  Process run = demo({"--frames", "60", "--json"});
  ASSERT_EQ(run.wait(std::chrono::minutes(3)), 0) << run.log();
  const auto summary = nlohmann::json::parse(run.output());
  expect_all_accounted_for(summary, 60);
  EXPECT_EQ(summary["zero_copy"], true);
  EXPECT_GT(summary["segmented"], 0);
  EXPECT_GT(summary["fps"], 0);
  EXPECT_GT(summary["latency_ms"]["median"], 0);
  EXPECT_GE(summary["latency_ms"]["p99"], summary["latency_ms"]["median"]);
  EXPECT_GT(summary["segments"]["median"], 1);
  EXPECT_TRUE(eventually([] { return processes_of_domain_9() == 0; }));
  EXPECT_EQ(shared_memory_of_roudi(), std::vector<std::string>());
  EXPECT_FALSE(roudi_answers());
}

TEST_F(Demo, PlaysTheRealScenesOnceWithoutLosingAFrame) {
  const std::string scenes = learn_scenes();
  if (scenes.empty()) GTEST_SKIP() << no_scenes;
  Process run = demo({"--source", "pcd:" + scenes, "--once", "--lossless", "--json"});
  ASSERT_EQ(run.wait(std::chrono::minutes(3)), 0) << run.log();
  const auto summary = nlohmann::json::parse(run.output());
  expect_all_accounted_for(summary, 45);
  EXPECT_EQ(summary["segmented"], 45);
  EXPECT_EQ(summary["dropped"], 0);
  EXPECT_EQ(summary["zero_copy"], true);
}

TEST_F(Demo, SendsCloudsOverTheNetworkWhenToldTo) {
  Process run = demo({"--frames", "20", "--json", "--no-shared-memory", "--lossless"});
  ASSERT_EQ(run.wait(std::chrono::minutes(3)), 0) << run.log();
  const auto summary = nlohmann::json::parse(run.output());
  expect_all_accounted_for(summary, 20);
  EXPECT_EQ(summary["segmented"], 20);
  EXPECT_EQ(summary["zero_copy"], false);
}

TEST_F(Demo, EndsEverythingInOrderOnCtrlC) {
  Process run = demo({});
  ASSERT_TRUE(eventually([&] { return run.output().find("frame") != std::string::npos; }))
      << run.log();
  run.signal(SIGINT);
  EXPECT_EQ(run.wait(), 0) << run.log();
  EXPECT_NE(run.output().find("planarity"), std::string::npos) << "no table of the last frame";
  EXPECT_TRUE(eventually([] { return processes_of_domain_9() == 0; }));
  EXPECT_EQ(shared_memory_of_roudi(), std::vector<std::string>());
}

TEST_F(Demo, RefusesAnUnknownOption) {
  Process run = demo({"--nonsense"});
  EXPECT_EQ(run.wait(), 2);
  EXPECT_NE(run.log().find("--nonsense"), std::string::npos);
}

}  // namespace
}  // namespace cleave::test
