// SPDX-License-Identifier: BSD-3-Clause
// One run of the whole stream with real processes, measured from outside as a user would.
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace cleave::benchmark {

struct StreamSetting {
  std::string source = "synthetic:medium";
  unsigned cameras = 1;
  unsigned fps = 60;
  unsigned workers = 1;  // a camera
  unsigned queue = 2;    // a camera
};

struct StreamFigures {
  double published_hz = 0;  // by the grabbers, all cameras together
  double segmented_hz = 0;  // all cameras together
  std::uint64_t published = 0;
  std::uint64_t dropped = 0;
  std::map<std::string, std::uint64_t> dropped_by_cause;
  double latency_median_ms = 0;  // from publication to segments in a client's hands; of the worst
  double latency_p99_ms = 0;     // camera
  std::map<std::string, double> stage_median_ms;  // of `cleave hz --latency`, of the first camera
  double segmenter_cpu = 0;                       // cores
  double grabber_cpu = 0;                         // cores, of the first camera's
};

// Starts segmenter, grabbers and clients on a domain of their own; a RouDi must run. The figures
// are of `seconds` of frames. Throws std::runtime_error with the logs when a process fails.
[[nodiscard]] StreamFigures run_stream(const StreamSetting& setting, unsigned seconds);

}  // namespace cleave::benchmark
