// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/status.hpp"

#include <unistd.h>

#include <array>
#include <ctime>
#include <list>
#include <utility>
#include <vector>

#include "idl/copy_fields.hpp"
#include "idl/fields.hpp"
#include "libcleave/sequence.hpp"

namespace cleave {
namespace {

using Counts = std::map<std::string, std::uint64_t>;

struct FromStream : fields::Copy<FromStream> {
  void text(const char* /*name*/, const char* from, std::string& to) { to = from; }
  template <class List, class From>
  void each(const char* /*name*/, const List& /*list*/, const From& from, Counts& to) {
    for (const cleave_v1_CauseCount& entry : elements_of(from)) to[entry.cause] = entry.count;
  }
};

// Lends texts and counts: both this and what it came from must outlive the message.
class ToStream : public fields::Copy<ToStream> {
 public:
  void text(const char* /*name*/, const std::string& from, char*& to) { to = text_of(from); }
  template <class List, class To>
  void each(const char* /*name*/, const List& /*list*/, const Counts& from, To& to) {
    auto& entries = lent_.emplace_back();
    for (const auto& [cause, count] : from) entries.push_back({text_of(cause), count});
    lend(to, entries);
  }

 private:
  // DDS's C types want char*; writing does not change the text.
  static char* text_of(const std::string& text) { return const_cast<char*>(text.c_str()); }

  std::list<std::vector<cleave_v1_CauseCount>> lent_;
};

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
  NodeReport report;
  fields::node_status(FromStream{}, status, report);
  return report;
}

NodeReport first_report(const Stream& stream, std::string node, std::string sensor) {
  NodeReport report;
  report.node = std::move(node);
  report.version = CLEAVE_VERSION;
  report.contract = contract_name;
  report.sensor = std::move(sensor);
  report.process_id = static_cast<std::uint32_t>(::getpid());
  report.transport_in_force = stream.transport();
  report.transport_reason = stream.transport_reason();
  return report;
}

double cpu_time_s() {
  constexpr double ns_per_s = 1e9;
  timespec time{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) / ns_per_s;
}

void StatusPublisher::publish(const NodeReport& report) {
  NodeStatus status{};
  ToStream to_stream;
  fields::node_status(to_stream, report, status);
  // A status that is lost is followed by the next one; the writer logs why.
  (void)writer_.publish(status);
}

}  // namespace cleave
