// SPDX-License-Identifier: BSD-3-Clause
// A long run of the real processes: does memory stay flat, do labels stay the same?
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace cleave::test {

struct SoakResult {
  std::size_t frames = 0;     // label maps that came
  std::size_t scenes = 0;     // of the loop that was played
  std::size_t differing = 0;  // label maps unlike the first one of their scene
  std::size_t resends = 0;    // label maps that came again
  // Resident memory after the first 500 frames, kB: smallest and largest of what was sampled.
  struct Memory {
    std::string process;
    std::size_t samples = 0;
    std::size_t smallest_kb = 0;
    std::size_t largest_kb = 0;
    [[nodiscard]] std::size_t spread_kb() const { return largest_kb - smallest_kb; }
  };
  std::vector<Memory> memory;  // of the segmenter and the grabber
};

inline constexpr std::size_t soak_warm_up_frames = 500;

// Renders a few scenes, loops them through grabber and segmenter in lossless mode as fast as they
// go, and compares every label map with the first one of its scene. A RouDi must run. `on_progress`
// is told the frames so far. Throws std::runtime_error, with the logs, when a process ends early.
[[nodiscard]] SoakResult soak(std::size_t frames, std::uint32_t domain,
                              const std::function<void(std::size_t)>& on_progress);

}  // namespace cleave::test
