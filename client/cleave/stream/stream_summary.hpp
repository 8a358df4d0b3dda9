// SPDX-License-Identifier: BSD-3-Clause
// Figures of a stream of segment lists, as they come in: rate, latency, gaps, segments.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "console/percentiles.hpp"

namespace cleave::client {

// What a frame waits for on its way from the camera to a client, in order.
inline constexpr std::array<const char*, 6> latency_stages = {
    "grabber", "transport", "waiting", "segmenting", "publishing", "delivery"};
using StageTimes = std::array<double, latency_stages.size()>;

// A segment list at the moment when this client had it in hand.
struct ListArrival {
  std::uint64_t frame_id;
  std::uint32_t epoch;
  double latency_ms;    // since the publication of the cloud, on this machine's clock
  StageTimes stage_ms;  // the same, and the time in the grabber, stage by stage
  std::optional<std::size_t> segments;  // empty: the frame was rejected
  std::chrono::steady_clock::time_point time;
};

class StreamSummary {
 public:
  void add(const ListArrival& arrival);

  [[nodiscard]] std::uint64_t lists() const { return lists_; }
  // Frame ids that were left out between two lists of one epoch.
  [[nodiscard]] std::uint64_t gaps() const { return gaps_; }
  // Over all lists, and over the latest 30; 0 before the second one.
  [[nodiscard]] double mean_rate_hz() const;
  [[nodiscard]] double recent_rate_hz() const;
  // Of the frames that were segmented.
  [[nodiscard]] Percentiles latency_ms() const { return latency_ms_.percentiles(); }
  // Of a stage, by its place in latency_stages.
  [[nodiscard]] Percentiles stage_ms(std::size_t stage) const {
    return stage_ms_.at(stage).percentiles();
  }
  // From the frame in the grabber's hands to its segments in the client's.
  [[nodiscard]] Percentiles total_ms() const { return total_ms_.percentiles(); }
  [[nodiscard]] Percentiles segments() const { return segments_.percentiles(); }

 private:
  std::uint64_t lists_ = 0;
  std::uint64_t gaps_ = 0;
  std::optional<ListArrival> first_;
  std::optional<ListArrival> last_;
  std::deque<std::chrono::steady_clock::time_point> recent_;
  RecentValues latency_ms_;
  std::array<RecentValues, latency_stages.size()> stage_ms_;
  RecentValues total_ms_;
  RecentValues segments_;
};

}  // namespace cleave::client
