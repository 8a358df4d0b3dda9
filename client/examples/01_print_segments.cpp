// SPDX-License-Identifier: BSD-3-Clause
// A planner's first client: prints the largest object of every frame. Needs no shared memory, no
// camera and no PCL: segment lists come over the public domain.
//
//   build/release/bin/01_print_segments [SENSOR]
#include <cstdio>

#include "libcleave/process/shutdown.hpp"
#include "libcleave/reader.hpp"
#include "libcleave/wait_set.hpp"

int main(int argc, char** argv) {
  cleave::Shutdown shutdown;  // Ctrl-C ends the loop below
  cleave::StreamOptions options = cleave::with_environment({});
  options.shared_memory = false;
  cleave::Stream stream(options);
  cleave::Reader<cleave::SegmentList> reader(stream, argc > 1 ? argv[1] : "camera");
  cleave::WaitSet wait_set;
  wait_set.attach(reader);
  shutdown.on_request([&] { wait_set.wake(); });

  while (!shutdown.requested()) {
    wait_set.wait(std::chrono::seconds(1));
    while (const auto list = reader.take()) {
      const auto& segments = (*list)->segments;
      if (segments._length < 2) continue;
      // Labels go by size: the first is most often the table, the second the largest object.
      const cleave::SegmentMessage& object = segments._buffer[1];
      std::printf("frame %llu: %u segments; the second has %u points around (%.2f, %.2f, %.2f) m\n",
                  static_cast<unsigned long long>((*list)->header.frame_id), segments._length,
                  object.point_count, static_cast<double>(object.centroid.x),
                  static_cast<double>(object.centroid.y), static_cast<double>(object.centroid.z));
    }
  }
  return 0;
}
