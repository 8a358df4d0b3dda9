#include "libcleave/status.hpp"

#include <array>
#include <ctime>
#include <vector>

namespace cleave {
namespace {

// DDS's C types want char*; writing does not change the text.
char* text(const std::string& s) {
  return const_cast<char*>(s.c_str());
}

std::vector<cleave_v1_CauseCount> causes(const std::map<std::string, std::uint64_t>& counts) {
  std::vector<cleave_v1_CauseCount> list;
  list.reserve(counts.size());
  for (const auto& [cause, count] : counts) list.push_back({text(cause), count});
  return list;
}

dds_sequence_cleave_v1_CauseCount sequence(std::vector<cleave_v1_CauseCount>& list) {
  const auto length = static_cast<std::uint32_t>(list.size());
  return {length, length, list.data(), false};
}

std::map<std::string, std::uint64_t> counts(const dds_sequence_cleave_v1_CauseCount& sequence) {
  std::map<std::string, std::uint64_t> result;
  for (std::uint32_t i = 0; i < sequence._length; ++i) {
    result[sequence._buffer[i].cause] = sequence._buffer[i].count;
  }
  return result;
}

}  // namespace

const char* to_string(NodeState state) {
  static constexpr std::array names = {"starting", "running", "source lost", "ended", "stopping"};
  const auto i = static_cast<std::size_t>(state);
  return i < names.size() ? names.at(i) : "unknown";
}

const char* to_string(Transport transport) {
  return transport == Transport::shared_memory ? "shared memory" : "network";
}

NodeReport report_of(const NodeStatus& status) {
  NodeReport r;
  r.node = status.node;
  r.version = status.version;
  r.sensor = status.sensor;
  r.process_id = status.process_id;
  r.state = static_cast<NodeState>(status.state);
  r.transport = static_cast<Transport>(status.transport_in_force);
  r.transport_reason = status.transport_reason;
  r.frames_in = status.frames_in;
  r.frames_out = status.frames_out;
  r.frames_dropped = status.frames_dropped;
  r.frames_rejected = status.frames_rejected;
  r.frames_in_flight = status.frames_in_flight;
  r.frames_zero_copy = status.frames_zero_copy;
  r.interruptions = status.interruptions;
  r.dropped_by_cause = counts(status.dropped_by_cause);
  r.rejected_by_cause = counts(status.rejected_by_cause);
  r.rate_hz = status.rate_hz;
  r.latency_median_ms = status.latency_median_ms;
  r.latency_p90_ms = status.latency_p90_ms;
  r.latency_p99_ms = status.latency_p99_ms;
  r.cpu_time_s = status.cpu_time_s;
  r.last_error = status.last_error;
  return r;
}

double cpu_time_s() {
  constexpr double ns_per_s = 1e9;
  timespec time{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) / ns_per_s;
}

void StatusPublisher::publish(const NodeReport& r) {
  std::vector<cleave_v1_CauseCount> dropped = causes(r.dropped_by_cause);
  std::vector<cleave_v1_CauseCount> rejected = causes(r.rejected_by_cause);
  NodeStatus status{};
  status.node = text(r.node);
  status.version = text(r.version);
  status.sensor = text(r.sensor);
  status.process_id = r.process_id;
  status.state = static_cast<cleave_v1_NodeState>(r.state);
  status.transport_in_force = static_cast<cleave_v1_Transport>(r.transport);
  status.transport_reason = text(r.transport_reason);
  status.frames_in = r.frames_in;
  status.frames_out = r.frames_out;
  status.frames_dropped = r.frames_dropped;
  status.frames_rejected = r.frames_rejected;
  status.frames_in_flight = r.frames_in_flight;
  status.frames_zero_copy = r.frames_zero_copy;
  status.interruptions = r.interruptions;
  status.dropped_by_cause = sequence(dropped);
  status.rejected_by_cause = sequence(rejected);
  status.rate_hz = r.rate_hz;
  status.latency_median_ms = r.latency_median_ms;
  status.latency_p90_ms = r.latency_p90_ms;
  status.latency_p99_ms = r.latency_p99_ms;
  status.cpu_time_s = r.cpu_time_s;
  status.last_error = text(r.last_error);
  // A status that is lost is followed by the next one; the writer logs why.
  (void)writer_.publish(status);
}

}  // namespace cleave
