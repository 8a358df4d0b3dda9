// SPDX-License-Identifier: BSD-3-Clause
// A planner's first client: prints the largest object of every frame. Needs no shared memory, no
// camera and no PCL: segment lists come over the public domain.
//
//   build/release/bin/01_print_segments [SENSOR]
#include <cstdio>

#include "libcleave/list_reader.hpp"
#include "libcleave/process/shutdown.hpp"
#include "libcleave/wait_set.hpp"

int main(int argc, char** argv) {
  cleave::Shutdown shutdown;  // Ctrl-C ends the loop below
  cleave::StreamOptions options = cleave::with_environment({});
  options.shared_memory = false;
  cleave::Stream stream(options);
  cleave::ListReader lists(stream, argc > 1 ? argv[1] : "camera");
  cleave::WaitSet wait_set;
  wait_set.attach(lists);
  shutdown.on_request([&] { wait_set.wake(); });

  while (!shutdown.requested()) {
    wait_set.wait(std::chrono::seconds(1));
    while (const auto list = lists.take()) {
      if (list->segments().size() < 2) continue;
      // Labels go by size: the first is most often the table, the second the largest object.
      const auto& [x, y, z] = list->segments()[1].centroid;
      std::printf(
          "frame %llu: %zu segments; the second has %u points around (%.2f, %.2f, %.2f) m\n",
          static_cast<unsigned long long>(list->header().frame_id), list->segments().size(),
          list->segments()[1].point_count, static_cast<double>(x), static_cast<double>(y),
          static_cast<double>(z));
    }
  }
  return 0;
}
