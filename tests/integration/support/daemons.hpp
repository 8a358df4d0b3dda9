// SPDX-License-Identifier: BSD-3-Clause
// Cleave's processes as a test starts them: quiet, on a domain of the test's own.
#pragma once

#include <string>
#include <vector>

#include "tests/integration/support/process.hpp"

namespace cleave::test {

// A folder with the shipped configuration and the words to start each program with it.
class Daemons {
 public:
  // `shared_memory` false: the network path, which needs no RouDi.
  Daemons(std::uint32_t domain, bool shared_memory)
      : domain_(domain), shared_memory_(shared_memory) {}

  [[nodiscard]] Process segmenter(std::vector<std::string> options = {}) const;
  [[nodiscard]] Process grabber(const std::string& source,
                                std::vector<std::string> options = {}) const;
  // Any program of ours, on this domain.
  [[nodiscard]] Process run(const std::string& name, const std::vector<std::string>& words) const;
  [[nodiscard]] std::uint32_t domain() const { return domain_; }

 private:
  std::uint32_t domain_;
  bool shared_memory_;
};

// Where the labelled real scenes are; empty if they are not on this machine.
std::string learn_scenes();

inline constexpr char no_scenes[] =
    "the labelled scenes are not on this machine: set CLEAVE_DATA to the folder that holds mosd/";

}  // namespace cleave::test
