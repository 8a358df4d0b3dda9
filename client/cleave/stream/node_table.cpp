#include "cleave/stream/node_table.hpp"

#include <spdlog/fmt/fmt.h>

#include "cleave/console/table.hpp"

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
  std::string text = fmt::format("\n{} (process {}, version {})\n", printable(r.node), r.process_id,
                                 printable(r.version));
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
    table.add_row({r.node, to_string(r.state), to_string(r.transport),
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
  return {{"node", r.node},
          {"version", r.version},
          {"sensor", r.sensor},
          {"process_id", r.process_id},
          {"state", to_string(r.state)},
          {"transport", to_string(r.transport)},
          {"transport_reason", r.transport_reason},
          {"frames_in", r.frames_in},
          {"frames_out", r.frames_out},
          {"frames_dropped", r.frames_dropped},
          {"frames_rejected", r.frames_rejected},
          {"frames_in_flight", r.frames_in_flight},
          {"frames_zero_copy", r.frames_zero_copy},
          {"interruptions", r.interruptions},
          {"dropped_by_cause", r.dropped_by_cause},
          {"rejected_by_cause", r.rejected_by_cause},
          {"rate_hz", decimal(r.rate_hz)},
          {"latency_ms",
           {{"median", decimal(r.latency_median_ms)},
            {"p90", decimal(r.latency_p90_ms)},
            {"p99", decimal(r.latency_p99_ms)}}},
          {"last_error", r.last_error}};
}

}  // namespace cleave::client
