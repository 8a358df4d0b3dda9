// Figures of a stream of segment lists, as they come in: rate, latency, gaps, segments.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "cleave/console/percentiles.hpp"

namespace cleave::client {

// A segment list at the moment when this client had it in hand.
struct ListArrival {
  std::uint64_t frame_id;
  std::uint32_t epoch;
  double latency_ms;  // since the publication of the cloud, on this machine's clock
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
  [[nodiscard]] Percentiles segments() const { return segments_.percentiles(); }

 private:
  std::uint64_t lists_ = 0;
  std::uint64_t gaps_ = 0;
  std::optional<ListArrival> first_;
  std::optional<ListArrival> last_;
  std::deque<std::chrono::steady_clock::time_point> recent_;
  RecentValues latency_ms_;
  RecentValues segments_;
};

}  // namespace cleave::client
