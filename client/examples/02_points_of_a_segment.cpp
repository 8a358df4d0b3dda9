// SPDX-License-Identifier: BSD-3-Clause
// Points and labels together, in place: finds the highest point (smallest y) of every segment
// without copying a cloud. A frame is a cloud and its label map, both in shared memory, and the
// list.
//
//   build/release/bin/02_points_of_a_segment [SENSOR]
#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>
#include <span>

#include "libcleave/frames/frame_reader.hpp"
#include "libcleave/process/shutdown.hpp"

namespace {

void print_highest_points(const cleave::CompleteFrame& frame) {
  const std::span<const float> xyz = frame.cloud.xyz();
  const std::span<const std::uint16_t> labels = frame.labels.labels();
  std::map<std::uint16_t, float> highest;  // by label; y points down
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] == 0) continue;  // of no segment
    const auto [entry, is_new] = highest.try_emplace(labels[i], std::numeric_limits<float>::max());
    entry->second = std::min(entry->second, xyz[3 * i + 1]);
  }
  std::printf("frame %llu:", static_cast<unsigned long long>(frame.cloud.header().frame_id));
  for (const auto& [label, y] : highest) std::printf(" %u: %.3f", label, static_cast<double>(y));
  std::printf(" (%s)\n", frame.cloud.zero_copy() ? "zero copy" : "copied");
}

}  // namespace

int main(int argc, char** argv) {
  const char* const sensor = argc > 1 ? argv[1] : "camera";
  cleave::Shutdown shutdown;
  cleave::Stream stream(cleave::with_environment({}));
  cleave::FrameReader frames(stream, sensor);
  shutdown.on_request([&] { frames.wake(); });

  while (!shutdown.requested()) {
    if (const auto frame = frames.next(std::chrono::seconds(1))) print_highest_points(*frame);
  }
  return 0;
}
