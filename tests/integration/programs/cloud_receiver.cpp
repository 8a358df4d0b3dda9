// SPDX-License-Identifier: BSD-3-Clause
// Takes 30 clouds and tells where they lay and how often anything large was copied: the reader's
// half of zero_copy_test. Usage: cloud_receiver shared|network SENSOR
#include <iostream>
#include <string>

#include "libcleave/reader.hpp"
#include "libcleave/wait_set.hpp"
#include "tests/integration/support/memcpy_counter.hpp"
#include "tests/integration/support/shared_mapping.hpp"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  using namespace cleave;
  StreamOptions options = with_environment({});
  options.shared_memory = std::string(argv[1]) == "shared";
  Stream stream(options);
  Reader<DepthCloud> reader(stream, argv[2]);
  WaitSet wait_set;
  wait_set.attach(reader);

  const std::uint64_t copies_before = test::large_copies();
  int clouds = 0, intact = 0, zero_copy = 0, in_shared_mapping = 0;
  while (clouds < 30 && wait_set.wait(std::chrono::seconds(30))) {
    while (const auto cloud = reader.take()) {
      ++clouds;
      const auto id = static_cast<float>((*cloud)->header.frame_id);
      intact += (*cloud)->xyz[0] == id && (*cloud)->xyz[921599] == -id ? 1 : 0;
      zero_copy += cloud->zero_copy() ? 1 : 0;
      in_shared_mapping += test::shared_mapping_of(&**cloud).empty() ? 0 : 1;
    }
  }
  std::cout << "clouds " << clouds << " intact " << intact << " zero_copy " << zero_copy
            << " in_shared_mapping " << in_shared_mapping << " copies "
            << test::large_copies() - copies_before << '\n';
  return 0;
}
