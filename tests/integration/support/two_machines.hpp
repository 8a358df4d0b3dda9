// SPDX-License-Identifier: BSD-3-Clause
// Two machines, which are two network namespaces with a cable between them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/integration/support/process.hpp"

namespace cleave::test {

inline constexpr char no_rights[] = "network namespaces need root, `ip` and `iptables`";

// Whether a command of the shell ended with 0.
bool succeeds(const std::string& command);

// Robot (10.77.0.1 on robot0) and office (10.77.0.2 on office0); gone, with their cable, when this
// is.
class TwoMachines {
 public:
  explicit TwoMachines(std::uint32_t domain);
  ~TwoMachines();
  TwoMachines(const TwoMachines&) = delete;
  TwoMachines& operator=(const TwoMachines&) = delete;

  // False: there are no rights to make them.
  [[nodiscard]] bool ready() const { return ready_; }
  // A program of ours on that machine, on the domain, with that machine's end of the cable as its
  // public interface.
  [[nodiscard]] Process robot(const std::vector<std::string>& words) const {
    return run(robot_, "robot0", words);
  }
  [[nodiscard]] Process office(const std::vector<std::string>& words) const {
    return run(office_, "office0", words);
  }
  // As it is configured: on loopback.
  [[nodiscard]] Process robot_alone(const std::vector<std::string>& words) const {
    return run(robot_, "lo", words);
  }
  // Whether a command of the shell ended with 0 there.
  [[nodiscard]] bool on_robot(const std::string& command) const {
    return succeeds(on(robot_, command));
  }
  [[nodiscard]] bool on_office(const std::string& command) const {
    return succeeds(on(office_, command));
  }
  // What arrives at the office is lost with this probability.
  void lose(const std::string& probability) const;
  void unplug() const;
  void plug_in() const;

 private:
  static std::string on(const std::string& machine, const std::string& command);
  [[nodiscard]] Process run(const std::string& machine, const std::string& interface,
                            const std::vector<std::string>& words) const;

  const std::string domain_;
  const std::string robot_;
  const std::string office_;
  bool ready_ = false;
};

}  // namespace cleave::test
