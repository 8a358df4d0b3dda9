// SPDX-License-Identifier: BSD-3-Clause
// Writes a line "FRAME_ID HASH" to stdout for every label map that it receives, until it has COUNT
// different frames. Usage: label_hasher SENSOR COUNT
#include <cstring>
#include <iostream>
#include <string>
#include <unordered_set>

#include "libcleave/reader.hpp"
#include "libcleave/wait_set.hpp"

namespace {

// FNV-1a over the labels, four at a time.
std::uint64_t hash_of(const cleave::LabelMap& map) {
  constexpr std::size_t labels_a_word = 4;
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (std::size_t i = 0; i + labels_a_word <= cleave::point_count(map.header);
       i += labels_a_word) {
    std::uint64_t word = 0;
    std::memcpy(&word, map.label + i, sizeof word);
    hash = (hash ^ word) * 0x100000001b3U;
  }
  return hash;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  using namespace cleave;
  Stream stream(with_environment({}));
  Reader<LabelMap> reader(stream, argv[1], ReaderDepth{8});
  WaitSet wait_set;
  wait_set.attach(reader);
  std::cerr << "ready" << std::endl;
  const std::size_t count = std::stoul(argv[2]);
  std::unordered_set<std::uint64_t> frames;
  while (frames.size() < count) {
    if (!wait_set.wait(std::chrono::seconds(60))) return 1;
    while (const auto map = reader.take()) {
      frames.insert((*map)->header.frame_id);
      std::cout << (*map)->header.frame_id << ' ' << hash_of(**map) << '\n' << std::flush;
    }
  }
  return 0;
}
