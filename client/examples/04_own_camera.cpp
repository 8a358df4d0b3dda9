// SPDX-License-Identifier: BSD-3-Clause
// Your own camera: depth images of whatever device you have, onto the stream. Here a slanted plane
// stands for what the device's SDK returns; all the rest is what you need.
//
//   build/release/bin/04_own_camera [FRAMES]
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

#include "libcleave/cloud_publisher.hpp"
#include "libcleave/process/shutdown.hpp"

namespace {

// Your SDK's: a depth image in millimetres, 0 = no measurement.
std::vector<std::uint16_t> wait_for_depth() {
  std::this_thread::sleep_for(std::chrono::milliseconds(33));
  std::vector<std::uint16_t> depth(std::size_t{848} * 480);
  for (std::size_t i = 0; i < depth.size(); ++i) {
    depth[i] = static_cast<std::uint16_t>(900 - i / 848);
  }
  return depth;
}

}  // namespace

int main(int argc, char** argv) {
  cleave::Shutdown shutdown;  // Ctrl-C ends the loop below
  const std::uint64_t frames = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : UINT64_MAX;
  cleave::Stream stream(cleave::with_environment({}));
  cleave::CloudSettings camera;
  camera.width = 848;
  camera.height = 480;
  camera.fx = camera.fy = 425;
  camera.cx = 423.5F;
  camera.cy = 239.5F;
  camera.parent_frame = "base_link";  // where the camera is on the robot
  camera.position = {0, 0, 1.2F};
  camera.orientation = {-.5F, .5F, -.5F, .5F};
  cleave::CloudPublisher publisher(stream, camera);

  while (!shutdown.requested() && publisher.published() < frames) {
    if (publisher.publish_depth(wait_for_depth(), 0.001F)) continue;
    const std::string obstacle = publisher.obstacle();
    std::fprintf(stderr, "dropped a frame: %s\n",
                 obstacle.empty() ? "readers hold all memory" : obstacle.c_str());
  }
  std::printf("%llu frames published\n", static_cast<unsigned long long>(publisher.published()));
  return 0;
}
