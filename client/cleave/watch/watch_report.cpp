// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/watch/watch_report.hpp"

#include <spdlog/fmt/fmt.h>

#include "console/table.hpp"

namespace cleave::client {
namespace {

std::string words_of(const std::map<std::string, std::uint64_t>& by_cause) {
  std::string text;
  for (const auto& [cause, count] : by_cause) {
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? " (" : ", ", count, cause);
  }
  return text.empty() ? text : text + ")";
}

}  // namespace

std::string frame_line(const ListArrival& arrival, double rate_hz, bool zero_copy,
                       const Account& account) {
  const std::string outcome =
      arrival.segments ? fmt::format("{:3} segments", *arrival.segments) : "    rejected";
  return fmt::format(
      "frame {:<6}  {}  {:5.1f} Hz  {:6.1f} ms  zero copy {:<3}  dropped {}  rejected {}",
      arrival.frame_id, outcome, rate_hz, arrival.latency_ms, zero_copy ? "yes" : "no",
      account.dropped, account.rejected);
}

std::string text_of(const WatchSummary& s) {
  std::string text =
      fmt::format("published {}, segmented {}, dropped {}{}, rejected {}{}\n", s.account.published,
                  s.account.segmented, s.account.dropped, words_of(s.account.dropped_by_cause),
                  s.account.rejected, words_of(s.account.rejected_by_cause));
  text += fmt::format("{:.1f} Hz, {:.0f} segments a frame\n", s.fps, s.segments.median);
  text += fmt::format("latency {:.1f} ms (median), {:.1f} ms (90 %), {:.1f} ms (99 %)\n",
                      s.latency_ms.median, s.latency_ms.p90, s.latency_ms.p99);
  text += fmt::format("the segmenter used {:.2f} of one core\n", s.segmenter_cpu);
  text += fmt::format("zero copy {}: {} ({})\n", s.zero_copy ? "yes" : "no", to_string(s.transport),
                      printable(s.transport_reason));
  return text;
}

Json json_of(const WatchSummary& s) {
  return {{"sensor", s.sensor},
          {"published", s.account.published},
          {"segmented", s.account.segmented},
          {"dropped", s.account.dropped},
          {"rejected", s.account.rejected},
          {"dropped_by_cause", s.account.dropped_by_cause},
          {"rejected_by_cause", s.account.rejected_by_cause},
          {"zero_copy", s.zero_copy},
          {"transport", to_string(s.transport)},
          {"transport_reason", s.transport_reason},
          {"fps", s.fps},
          {"latency_ms", json_of(s.latency_ms)},
          {"segments", json_of(s.segments)},
          {"segmenter_cpu", s.segmenter_cpu}};
}

}  // namespace cleave::client
