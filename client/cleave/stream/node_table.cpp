// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/stream/node_table.hpp"

#include <spdlog/fmt/fmt.h>

#include "console/contract_json.hpp"
#include "console/table.hpp"
#include "idl/fields.hpp"

namespace cleave::client {
namespace {

using Counts = std::map<std::string, std::uint64_t>;

std::string words_of(const Counts& by_cause) {
  std::string text;
  for (const auto& [cause, count] : by_cause) {
    if (count == 0) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, cause);
  }
  return text;
}

std::string details_of(const NodeReport& r) {
  std::string text = fmt::format("\n{} (process {}, version {}, contract {})\n", printable(r.node),
                                 r.process_id, printable(r.version), printable(r.contract));
  const auto append = [&](const char* title, const std::string& value) {
    if (!value.empty()) text += fmt::format("  {:<11}{}\n", title, printable(value));
  };
  append("transport", r.transport_reason);
  append("dropped", words_of(r.dropped_by_cause));
  append("rejected", words_of(r.rejected_by_cause));
  if (r.interruptions > 0)
    append("lost", fmt::format("{} times, resets of its clock included", r.interruptions));
  append("last error", r.last_error);
  return text;
}

struct NodeFields : JsonFields {
  template <class Enum>
  void choice(const char* name, const Enum& value) {
    json[name] = to_string(value);
  }
  template <class List>
  void each(const char* name, const List& /*list*/, const Counts& counts) {
    json[name] = counts;
  }
};

}  // namespace

std::string node_table(const std::vector<NodeReport>& reports) {
  Table table({{"node", Align::left},
               {"state", Align::left},
               {"transport", Align::left},
               {"in", Align::right},
               {"out", Align::right},
               {"dropped", Align::right},
               {"rejected", Align::right},
               {"in flight", Align::right},
               {"zero copy", Align::right},
               {"rate [Hz]", Align::right},
               {"latency median/p90/p99 [ms]", Align::right}});
  std::string details;
  for (const NodeReport& r : reports) {
    table.add_row({r.node, to_string(r.state), to_string(r.transport_in_force),
                   fmt::format("{}", r.frames_in), fmt::format("{}", r.frames_out),
                   fmt::format("{}", r.frames_dropped), fmt::format("{}", r.frames_rejected),
                   fmt::format("{}", r.frames_in_flight), fmt::format("{}", r.frames_zero_copy),
                   fmt::format("{:.1f}", r.rate_hz),
                   fmt::format("{:.1f}/{:.1f}/{:.1f}", r.latency_median_ms, r.latency_p90_ms,
                               r.latency_p99_ms)});
    details += details_of(r);
  }
  return table.to_string() + details;
}

Json json_of(const NodeReport& r) {
  NodeFields fields;
  cleave::fields::node_status(fields, r);
  fields.json["transport"] = to_string(r.transport_in_force);
  fields.json["latency_ms"] = {{"median", decimal(r.latency_median_ms)},
                               {"p90", decimal(r.latency_p90_ms)},
                               {"p99", decimal(r.latency_p99_ms)}};
  return std::move(fields.json);
}

}  // namespace cleave::client
