// SPDX-License-Identifier: BSD-3-Clause
// Publishes 30 clouds and tells where they lay and how often anything large was copied: the
// writer's half of zero_copy_test. Usage: cloud_publisher shared|network SENSOR
#include <iostream>
#include <string>
#include <thread>

#include "libcleave/writer.hpp"
#include "tests/integration/support/memcpy_counter.hpp"
#include "tests/integration/support/shared_mapping.hpp"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  using namespace cleave;
  StreamOptions options = with_environment({});
  options.shared_memory = std::string(argv[1]) == "shared";
  Stream stream(options);
  Writer<DepthCloud> writer(stream, argv[2]);
  while (writer.matched_readers() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));

  const std::uint64_t copies_before = test::large_copies();
  bool all_shared = true;
  for (std::uint64_t id = 1; id <= 30; ++id) {
    auto loan = writer.loan();
    if (!loan) return 1;
    all_shared = all_shared && !test::shared_mapping_of(&**loan).empty();
    (*loan)->header = FrameHeader{};
    (*loan)->header.frame_id = id;
    (*loan)->header.width = 640;
    (*loan)->header.height = 480;
    (*loan)->xyz[0] = static_cast<float>(id);
    (*loan)->xyz[921599] = -static_cast<float>(id);
    if (!writer.publish(std::move(*loan))) return 1;
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
  }
  std::cout << "in_shared_mapping " << all_shared << " copies "
            << test::large_copies() - copies_before << '\n';
  std::this_thread::sleep_for(std::chrono::milliseconds(500));  // let the reader take the last one
  return 0;
}
