// SPDX-License-Identifier: BSD-3-Clause
// The statuses of all nodes of a domain.
#pragma once

#include <chrono>
#include <map>
#include <string>
#include <vector>

#include "libcleave/process/shutdown.hpp"
#include "libcleave/reader.hpp"
#include "libcleave/status.hpp"
#include "libcleave/wait_set.hpp"

namespace cleave::client {

class StatusReader {
 public:
  explicit StatusReader(Stream& stream);

  // Waits up to `patience` for a first status, and then a moment for those of the other nodes; less
  // when shutdown is requested. The latest of each node, by its name; empty if nobody answers.
  [[nodiscard]] std::vector<NodeReport> collect(Shutdown& shutdown,
                                                std::chrono::milliseconds patience);

  // The latest status of each node that was heard of in the last 3 s, by name; does not wait.
  [[nodiscard]] std::vector<NodeReport> living();

 private:
  struct Heard {
    NodeReport report;
    std::chrono::steady_clock::time_point time;
  };
  void take();

  Reader<NodeStatus> reader_;
  WaitSet wait_set_;
  std::map<std::string, Heard> nodes_;
};

}  // namespace cleave::client
