// SPDX-License-Identifier: BSD-3-Clause
// Writes every label map that it receives to FOLDER/<frame id>.labels: the points' labels, 2 bytes
// each. Usage: label_recorder shared|network SENSOR COUNT FOLDER
#include <fstream>
#include <iostream>
#include <string>

#include "libcleave/reader.hpp"
#include "libcleave/wait_set.hpp"

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  using namespace cleave;
  StreamOptions options = with_environment({});
  options.shared_memory = std::string(argv[1]) == "shared";
  Stream stream(options);
  Reader<LabelMap> reader(stream, argv[2], ReaderDepth{8});
  WaitSet wait_set;
  wait_set.attach(reader);
  std::cerr << "ready" << std::endl;
  int left = std::stoi(argv[3]);
  while (left > 0 && wait_set.wait(std::chrono::seconds(60))) {
    while (const auto map = reader.take()) {
      const FrameHeader& header = (*map)->header;
      std::ofstream file(std::string(argv[4]) + "/" + std::to_string(header.frame_id) + ".labels",
                         std::ios::binary);
      file.write(reinterpret_cast<const char*>((*map)->label),
                 static_cast<std::streamsize>(point_count(header) * sizeof(std::uint16_t)));
      if (!file) return 1;
      --left;
    }
  }
  return left == 0 ? 0 : 1;
}
