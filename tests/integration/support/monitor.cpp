// SPDX-License-Identifier: BSD-3-Clause
#include "tests/integration/support/monitor.hpp"

#include "tests/integration/support/process.hpp"

namespace cleave::test {
namespace {

StreamOptions options_of(std::uint32_t domain) {
  StreamOptions options;
  options.domain = domain;
  options.shared_memory = false;
  return options;
}

}  // namespace

Monitor::Monitor(std::uint32_t domain, const std::string& sensor)
    : stream_(options_of(domain)),
      segments_(stream_, sensor, ReaderDepth{64}),
      statuses_(stream_, "", ReaderDepth{64}) {}

void Monitor::poll() {
  while (const auto list = segments_.take()) {
    lists_.push_back({(*list)->header.epoch, (*list)->header.frame_id, (*list)->outcome,
                      (*list)->segments._length, (*list)->header.device_time_us,
                      (*list)->header.capture_time_ns});
  }
  while (const auto status = statuses_.take()) {
    NodeReport report = report_of(**status);
    nodes_[report.node].push_back(report);
  }
}

NodeReport Monitor::status(const std::string& node) const {
  const auto found = nodes_.find(node);
  return found == nodes_.end() ? NodeReport{} : found->second.back();
}

std::vector<NodeReport> Monitor::history(const std::string& node) const {
  const auto found = nodes_.find(node);
  return found == nodes_.end() ? std::vector<NodeReport>{} : found->second;
}

bool Monitor::lists_flow(std::size_t count) {
  poll();
  const std::size_t wanted = lists_.size() + count;
  return eventually([&] {
    poll();
    return lists_.size() >= wanted;
  });
}

}  // namespace cleave::test
