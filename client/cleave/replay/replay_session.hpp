// SPDX-License-Identifier: BSD-3-Clause
// A recording back onto the stream, from its first frame to its last.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cleave/replay/replay_clock.hpp"
#include "cleave/replay/sensor_replay.hpp"
#include "libcleave/process/shutdown.hpp"
#include "recording/frames/read_ahead.hpp"

namespace cleave::client {

struct ReplayPlan {
  std::filesystem::path file;
  recording::Selection selection;
  double rate = 1;                                    // 0 = as fast as possible
  double max_gap_s = recording::GapLimit::default_s;  // between two frames, by the recording's time
  bool loop = false;
  std::optional<std::uint32_t> window;  // lossless: clouds on their way to the segmenter
};

class ReplaySession {
 public:
  // Throws recording::FileError for a file that cannot be replayed.
  ReplaySession(Stream& stream, ReplayPlan plan);

  // Waits for a reader of the first frame's sensor, publishes all frames, and lingers until readers
  // have them, or until shutdown is requested. `on_tick` is called several times a second.
  void run(Shutdown& shutdown, const std::function<void()>& on_tick);

  [[nodiscard]] const std::map<recording::Kind, std::uint64_t>& published() const {
    return published_;
  }
  // Of the last frame, in seconds since the first one of its pass.
  [[nodiscard]] double position_s() const { return position_s_; }
  // Frames a second, from the first one to the last.
  [[nodiscard]] double mean_rate_hz() const;
  // What of the file is damaged; known once it has been read.
  [[nodiscard]] std::vector<std::string> problems() const { return reader_.problems(); }

 private:
  using Clock = std::chrono::steady_clock;
  void publish(const recording::AheadFrame& ahead, Shutdown& shutdown,
               const std::function<void()>& on_tick);
  void wait_until_due(const recording::AheadFrame& ahead, Shutdown& shutdown,
                      const std::function<void()>& on_tick);
  void wait_for_readers(const SensorReplay& sensor, Shutdown& shutdown,
                        const std::function<void()>& on_tick);
  SensorReplay& sensor_of(const recording::Frame& frame);
  void note(const recording::AheadFrame& ahead);
  void linger(Shutdown& shutdown);
  void update();

  Stream& stream_;
  ReplayPlan plan_;
  recording::ReadAhead reader_;
  ReplayClock clock_;
  std::map<std::string, SensorReplay> sensors_;
  std::map<recording::Kind, std::uint64_t> published_;
  std::optional<std::int64_t> first_log_ns_;
  double position_s_ = 0;
  std::optional<Clock::time_point> began_;
  Clock::time_point ended_{};
};

}  // namespace cleave::client
