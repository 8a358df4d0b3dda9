// SPDX-License-Identifier: BSD-3-Clause
// A long run: memory and labels of so many frames, with real processes and a RouDi of its own.
// Usage: benchmark_soak [FRAMES], default 10000. Exit code 1 unless memory is flat within 2 MB
// after the first 500 frames and every repeated frame has the labels that it had at first.
#include "tests/integration/support/soak.hpp"

#include <unistd.h>

#include <cstdio>
#include <exception>
#include <iostream>
#include <string>

#include "tests/integration/support/roudi_fixture.hpp"

namespace {

using namespace cleave::test;

constexpr std::size_t largest_spread_kb = 2048;

bool print(const SoakResult& result, std::size_t frames) {
  bool good = result.frames == frames && result.differing == 0;
  std::printf("frames %zu, scenes in the loop %zu, label maps unlike their scene's first %zu\n",
              result.frames, result.scenes, result.differing);
  for (const SoakResult::Memory& memory : result.memory) {
    std::printf("%-17s resident %zu to %zu kB: within %zu kB after frame %zu (%zu samples)\n",
                memory.process.c_str(), memory.smallest_kb, memory.largest_kb, memory.spread_kb(),
                soak_warm_up_frames, memory.samples);
    good = good && memory.samples > 0 && memory.spread_kb() <= largest_spread_kb;
  }
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::size_t frames = argc > 1 ? std::stoul(argv[1]) : 10000;
    const bool terminal = ::isatty(STDERR_FILENO) == 1;
    const RouDi roudi;
    const SoakResult result = soak(frames, 22, [&](std::size_t so_far) {
      if (terminal) std::fprintf(stderr, "\r%zu of %zu frames ", so_far, frames);
    });
    if (terminal) std::fputc('\n', stderr);
    return print(result, frames) ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << "benchmark_soak: " << error.what() << '\n';
    return 1;
  }
}
