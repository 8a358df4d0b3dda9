// SPDX-License-Identifier: BSD-3-Clause
// A node's status in C++ terms, its publication and its way back from the wire.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "libcleave/stream.hpp"
#include "libcleave/types.hpp"
#include "libcleave/writer.hpp"

namespace cleave {

enum class NodeState { starting, running, source_lost, ended, stopping };
[[nodiscard]] const char* to_string(NodeState state);
[[nodiscard]] const char* to_string(Transport transport);

// The members of the contract's NodeStatus, as idl/fields.hpp visits them.
struct NodeReport {
  std::string node;  // grabber_node() or segmenter_node(), in idl/topics.hpp
  std::string version;
  std::string contract;
  std::string sensor;
  std::uint32_t process_id = 0;
  NodeState state = NodeState::starting;
  Transport transport_in_force = Transport::network;
  std::string transport_reason;
  std::uint64_t frames_in = 0;
  std::uint64_t frames_out = 0;
  std::uint64_t frames_dropped = 0;
  std::uint64_t frames_rejected = 0;
  std::uint64_t frames_in_flight = 0;
  std::uint64_t frames_zero_copy = 0;
  std::uint64_t interruptions = 0;
  std::map<std::string, std::uint64_t> dropped_by_cause;
  std::map<std::string, std::uint64_t> rejected_by_cause;
  float rate_hz = 0;
  float latency_median_ms = 0;
  float latency_p90_ms = 0;
  float latency_p99_ms = 0;
  double cpu_time_s = 0;  // of the process, since its start
  std::string last_error;
};

[[nodiscard]] NodeReport report_of(const NodeStatus& status);

// What a node of this process says of itself before it has counted anything.
[[nodiscard]] NodeReport first_report(const Stream& stream, std::string node, std::string sensor);

// Of this process, user and system, since its start.
[[nodiscard]] double cpu_time_s();

class StatusPublisher {
 public:
  explicit StatusPublisher(Stream& stream) : writer_(stream, "") {}
  void publish(const NodeReport& report);

 private:
  Writer<NodeStatus> writer_;
};

}  // namespace cleave
