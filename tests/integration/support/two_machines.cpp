// SPDX-License-Identifier: BSD-3-Clause
#include "tests/integration/support/two_machines.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

namespace cleave::test {

bool succeeds(const std::string& command) {
  const std::vector<std::string> words = {"/usr/bin/env", "bash", "-c", command};
  return Process(words).wait() == 0;
}

TwoMachines::TwoMachines(std::uint32_t domain)
    : domain_(std::to_string(domain)),
      robot_("cleave_robot_" + std::to_string(::getpid())),
      office_("cleave_office_" + std::to_string(::getpid())) {
  ready_ = Process({"/usr/bin/env", "iptables", "--version"}).wait() == 0 &&
           succeeds("ip netns add " + robot_ + " && ip netns add " + office_) &&
           succeeds("ip link add robot0 netns " + robot_ + " type veth peer name office0 netns " +
                    office_) &&
           on_robot(
               "ip addr add 10.77.0.1/24 dev robot0; ip link set lo up; "
               "ip link set robot0 up") &&
           on_office(
               "ip addr add 10.77.0.2/24 dev office0; ip link set lo up; "
               "ip link set office0 up") &&
           on_office("iptables -L -n");
}

TwoMachines::~TwoMachines() {
  (void)succeeds("ip netns del " + robot_);
  (void)succeeds("ip netns del " + office_);
}

void TwoMachines::lose(const std::string& probability) const {
  ASSERT_TRUE(on_office("iptables -A INPUT -i office0 -m statistic --mode random --probability " +
                        probability + " -j DROP"));
}

void TwoMachines::unplug() const {
  ASSERT_TRUE(on_robot("ip link set robot0 down"));
}

void TwoMachines::plug_in() const {
  ASSERT_TRUE(on_robot("ip link set robot0 up"));
}

std::string TwoMachines::on(const std::string& machine, const std::string& command) {
  return "ip netns exec " + machine + " bash -c '" + command + "'";
}

Process TwoMachines::run(const std::string& machine, const std::string& interface,
                         const std::vector<std::string>& words) const {
  std::vector<std::string> command = {"/usr/bin/env", "ip",    "netns",
                                      "exec",         machine, program(words.front())};
  command.insert(command.end(), words.begin() + 1, words.end());
  return Process(command, {{"CLEAVE_DOMAIN", domain_}, {"CLEAVE_INTERFACE", interface}});
}

}  // namespace cleave::test
