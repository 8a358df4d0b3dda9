// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/watch/watch_end.hpp"

#include <spdlog/fmt/fmt.h>

#include "console/table.hpp"

namespace cleave::client {
namespace {

using std::chrono_literals::operator""s;

constexpr auto patience = 30s;

std::string words_of(const NodeReport& report) {
  std::string text = fmt::format("{} says '{}' with {} frames in and {} out", report.node,
                                 to_string(report.state), report.frames_in, report.frames_out);
  if (!report.last_error.empty()) text += ": " + report.last_error;
  return printable(text);
}

}  // namespace

void EndCondition::add_segment_list(SteadyTime now) {
  ++lists_;
  last_arrival_ = now;
}

std::optional<WatchEnd> EndCondition::check(const FrameAccount& account, SteadyTime now) const {
  if (frames_ && lists_ >= *frames_) return WatchEnd::frames_reached;
  if (account.complete(now)) return WatchEnd::source_ended;
  if (now - last_arrival_ >= patience) return WatchEnd::nothing_arrives;
  return std::nullopt;
}

std::string why_nothing_arrives(const FrameAccount& account, const std::string& sensor,
                                std::uint32_t domain) {
  std::string text =
      fmt::format("no segment list of sensor '{}' came for {} s on domain {}: ", sensor,
                  patience.count(), domain);
  if (!account.grabber() && !account.segmenter()) {
    return text +
           "neither a grabber nor a segmenter answers; start both, or ./service/demo, with the "
           "same sensor and CLEAVE_DOMAIN";
  }
  text +=
      account.grabber() ? words_of(*account.grabber()) : "no grabber answers; start cleave-grabber";
  text += "; ";
  text += account.segmenter() ? words_of(*account.segmenter())
                              : "no segmenter answers; start cleave-segmenter";
  return text + " (`cleave status` tells more)";
}

}  // namespace cleave::client
