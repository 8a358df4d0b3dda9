// SPDX-License-Identifier: BSD-3-Clause
// What is loopback by configuration hears loopback alone: every socket of every process, held
// against datagrams from another machine.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "tests/integration/support/process.hpp"
#include "tests/integration/support/two_machines.hpp"

namespace cleave::test {
namespace {

constexpr std::uint32_t loopback_domain = 37;

struct Socket {
  std::uint32_t port = 0;
  std::uint64_t dropped = 0;  // datagrams that came in and were not taken
};

// The bound UDP sockets of a process, by inode; its network namespace's.
std::map<std::string, Socket> udp_sockets(pid_t process) {
  const std::filesystem::path folder = "/proc/" + std::to_string(process);
  std::map<std::string, Socket> own;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "fd")) {
    std::error_code gone;
    const std::string target = std::filesystem::read_symlink(entry.path(), gone);
    if (target.starts_with("socket:[")) own[target.substr(8, target.size() - 9)] = {};
  }
  std::map<std::string, Socket> found;
  std::ifstream table(folder / "net/udp");
  std::string line;
  std::getline(table, line);
  while (std::getline(table, line)) {
    std::istringstream words(line);
    std::vector<std::string> fields;
    for (std::string word; words >> word;) fields.push_back(word);
    const std::string& inode = fields.at(9);
    if (!own.contains(inode)) continue;
    const auto port = std::stoul(fields.at(1).substr(fields.at(1).find(':') + 1), nullptr, 16);
    found[inode] = {static_cast<std::uint32_t>(port), std::stoull(fields.back())};
  }
  return found;
}

// Of the domain's ports and those of the bulk domain.
std::map<std::string, Socket> dds_sockets(pid_t process) {
  std::map<std::string, Socket> sockets = udp_sockets(process);
  std::erase_if(sockets, [](const auto& s) {
    const auto of = [&](std::uint32_t domain) {
      return s.second.port >= 7400 + 250 * domain && s.second.port < 7650 + 250 * domain;
    };
    return !of(loopback_domain) && !of(loopback_domain + 100);
  });
  return sockets;
}

class Loopback : public testing::Test {
 protected:
  void SetUp() override {
    if (!machines_.ready()) GTEST_SKIP() << no_rights;
  }
  static std::string config(const std::string& name) {
    return std::string(CLEAVE_SOURCE_DIR) + "/config/" + name;
  }
  // Ten datagrams to each socket of the process, from the office or from the robot itself.
  void send_to(const Process& process, bool from_office) const {
    for (const auto& [inode, socket] : dds_sockets(process.id())) {
      const std::string command = "for i in 1 2 3 4 5 6 7 8 9 10; do echo RTPS > /dev/udp/" +
                                  std::string(from_office ? "10.77.0.1" : "127.0.0.1") + "/" +
                                  std::to_string(socket.port) + "; done";
      ASSERT_TRUE(from_office ? machines_.on_office(command) : machines_.on_robot(command));
    }
  }
  void expect_deaf_to_the_office(const Process& process) const {
    const auto before = dds_sockets(process.id());
    // Two domains with two sockets each.
    ASSERT_GE(before.size(), 4U) << process.log();
    send_to(process, true);
    for (const auto& [inode, socket] : dds_sockets(process.id())) {
      EXPECT_EQ(socket.dropped - before.at(inode).dropped, 10U) << "port " << socket.port;
    }
    const auto after = dds_sockets(process.id());
    send_to(process, false);
    for (const auto& [inode, socket] : dds_sockets(process.id())) {
      EXPECT_EQ(socket.dropped, after.at(inode).dropped) << "loopback, port " << socket.port;
    }
  }

  const TwoMachines machines_{loopback_domain};
};

TEST_F(Loopback, IsAllThatEveryProcessHears) {
  Process segmenter = machines_.robot_alone(
      {"cleave-segmenter", "--config", config("segmenter.yaml"), "--no-shared-memory"});
  ASSERT_TRUE(segmenter.logs("ready")) << segmenter.log();
  Process grabber = machines_.robot_alone({"cleave-grabber", "--config", config("grabber.yaml"),
                                           "--no-shared-memory", "--source", "synthetic:simple"});
  ASSERT_TRUE(grabber.logs("sensor 'camera'")) << grabber.log();
  Process watch = machines_.robot_alone({"cleave", "watch", "--quiet"});
  ASSERT_TRUE(watch.logs("watching")) << watch.log();
  expect_deaf_to_the_office(segmenter);
  expect_deaf_to_the_office(grabber);
  expect_deaf_to_the_office(watch);
}

TEST_F(Loopback, IsAllThatTheBulkDomainHearsOfWhoIsOnTheNetwork) {
  Process segmenter = machines_.robot(
      {"cleave-segmenter", "--config", config("segmenter.yaml"), "--no-shared-memory"});
  ASSERT_TRUE(segmenter.logs("ready")) << segmenter.log();
  const auto before = dds_sockets(segmenter.id());
  send_to(segmenter, true);
  for (const auto& [inode, socket] : dds_sockets(segmenter.id())) {
    const bool bulk = socket.port >= 7400 + 250 * (loopback_domain + 100);
    EXPECT_EQ(socket.dropped - before.at(inode).dropped, bulk ? 10U : 0U) << socket.port;
  }
}

}  // namespace
}  // namespace cleave::test
