// SPDX-License-Identifier: BSD-3-Clause
// A planner outside the checkout: of every frame the segment whose points come nearest to the
// camera, read in place. Ends after so many frames.
//
//   planner [SENSOR [FRAMES]]
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "libcleave/frames/frame_reader.hpp"

int main(int argc, char** argv) {
  cleave::Stream stream(cleave::with_environment({}));
  cleave::FrameReader frames(stream, argc > 1 ? argv[1] : "camera");
  int left = argc > 2 ? std::atoi(argv[2]) : 100;
  while (left > 0) {
    const auto frame = frames.next(std::chrono::seconds(1));
    if (!frame) continue;
    const auto xyz = frame->cloud.xyz();
    const auto labels = frame->labels.labels();
    float nearest_m = 1000;
    unsigned label = 0;  // of no segment
    for (std::size_t i = 0; i < labels.size(); ++i) {
      if (labels[i] == 0 || !(xyz[3 * i + 2] < nearest_m)) continue;
      nearest_m = xyz[3 * i + 2];
      label = labels[i];
    }
    std::printf("segment %u at %.3f m (%s)\n", label, static_cast<double>(nearest_m),
                frame->cloud.zero_copy() ? "zero copy" : "copied");
    --left;
  }
}
