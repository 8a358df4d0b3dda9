// SPDX-License-Identifier: BSD-3-Clause
// Points and labels together, in place: finds the highest point (smallest y) of every segment
// without copying a cloud. The joiner pairs each cloud with its label map, both in shared memory.
//
//   build/release/bin/02_points_of_a_segment [SENSOR]
#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>

#include "libcleave/joiner.hpp"
#include "libcleave/process/shutdown.hpp"
#include "libcleave/wait_set.hpp"

namespace {

void print_highest_points(const cleave::JoinedFrame& frame) {
  const cleave::DepthCloud& cloud = *frame.cloud;
  std::map<std::uint16_t, float> highest;  // by label; y points down
  for (std::uint64_t i = 0; i < cleave::point_count(cloud.header); ++i) {
    const std::uint16_t label = frame.labels->label[i];
    if (label == 0) continue;  // no measurement
    const auto [entry, is_new] = highest.try_emplace(label, std::numeric_limits<float>::max());
    entry->second = std::min(entry->second, cloud.xyz[3 * i + 1]);
  }
  std::printf("frame %llu:", static_cast<unsigned long long>(cloud.header.frame_id));
  for (const auto& [label, y] : highest) std::printf(" %u: %.3f", label, static_cast<double>(y));
  std::printf(" (%s)\n", frame.cloud.zero_copy() ? "zero copy" : "copied");
}

}  // namespace

int main(int argc, char** argv) {
  const char* const sensor = argc > 1 ? argv[1] : "camera";
  cleave::Shutdown shutdown;
  cleave::Stream stream(cleave::with_environment({}));
  cleave::Reader<cleave::DepthCloud> clouds(stream, sensor);
  cleave::Reader<cleave::LabelMap> labels(stream, sensor);
  cleave::Joiner joiner;
  cleave::WaitSet wait_set;
  wait_set.attach(clouds);
  wait_set.attach(labels);
  shutdown.on_request([&] { wait_set.wake(); });

  while (!shutdown.requested()) {
    wait_set.wait(std::chrono::seconds(1));
    while (auto cloud = clouds.take()) {
      if (const auto frame = joiner.add(std::move(*cloud))) print_highest_points(*frame);
    }
    while (auto map = labels.take()) {
      if (const auto frame = joiner.add(std::move(*map))) print_highest_points(*frame);
    }
  }
  return 0;
}
