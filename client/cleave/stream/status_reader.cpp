// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/stream/status_reader.hpp"

#include <algorithm>

namespace cleave::client {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono_literals::operator""ms;

constexpr auto moment = 500ms;      // in which the other nodes answer, once one has
constexpr auto heard_for = 3000ms;  // nodes report every half second
constexpr auto status_wait = 100ms;

}  // namespace

StatusReader::StatusReader(Stream& stream) : reader_(stream, "") {
  wait_set_.attach(reader_);
}

void StatusReader::take() {
  while (const auto sample = reader_.take()) {
    NodeReport report = report_of(**sample);
    std::string node = report.node;
    nodes_[std::move(node)] = {std::move(report), Clock::now()};
  }
}

std::vector<NodeReport> StatusReader::collect(Shutdown& shutdown,
                                              std::chrono::milliseconds patience) {
  Clock::time_point end = Clock::now() + patience;
  bool answered = false;
  while (!shutdown.requested() && Clock::now() < end) {
    take();
    if (!answered && !nodes_.empty()) {
      answered = true;
      end = std::min(end, Clock::now() + moment);
    }
    (void)wait_set_.wait(status_wait);
  }
  return living();
}

std::vector<NodeReport> StatusReader::living() {
  take();
  std::erase_if(nodes_, [now = Clock::now()](const auto& node) {
    return now - node.second.time > heard_for;
  });
  std::vector<NodeReport> reports;
  for (const auto& [name, heard] : nodes_) reports.push_back(heard.report);
  return reports;
}

}  // namespace cleave::client
