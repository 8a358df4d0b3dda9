// SPDX-License-Identifier: BSD-3-Clause
// The SCENE in a source's name `synthetic:SCENE`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace cleave::render {

// What goes wrong with the camera, each thing once. Times in ms since its first frame, but for
// in_use_ms: since its name was used for the first time.
struct CameraFaults {
  std::uint32_t unplug_at_ms = 0;        // 0 = never
  std::uint32_t replug_after_ms = 1000;  // how long it stays unplugged
  std::uint32_t stall_at_ms = 0;         // 0 = never: it is there, but sends no frame
  std::uint32_t stall_ms = 3000;         // how long; opening it again does not help
  std::uint32_t in_use_ms = 0;           // as long as that another program has it
  std::uint32_t clock_reset_at_ms = 0;   // 0 = never: its clock begins anew
  std::uint32_t drop_at_ms = 0;          // 0 = never: it numbers frames that nobody gets
  std::uint32_t drop_frames = 5;         // so many
};

// SCENE = PRESET[?KEY=VALUE[&KEY=VALUE]...], for example crowded?seed=3&motion=1.
struct SceneRequest {
  std::string preset;                    // simple, medium or crowded
  std::uint32_t seed = 1;                // of the scene and its noise
  std::optional<std::uint32_t> objects;  // exactly so many instead of the preset's range, 2 to 30
  std::uint32_t frames = 8;              // in the loop, 1 to 600; 60 unless given when in motion
  bool motion = false;                   // whether the camera moves
  bool noise = true;                     // false: exact depth, rounded to 1 mm
  std::uint32_t fps = 30;                // 1 to 240
  std::uint32_t width = 640;             // pixels, 16 to 1600
  std::uint32_t height = 480;            // pixels, 16 to 1200
  bool mirrored = false;                 // left and right are swapped unless it is told otherwise
  bool registration = false;             // the camera can register its depth to a colour image
  CameraFaults faults;
};

// Throws std::invalid_argument for an unknown preset or key, a value that is not a whole number
// within its range, and a key that is given twice; the text names it, says what is known, and gives
// an example.
[[nodiscard]] SceneRequest parse_scene(std::string_view text);

}  // namespace cleave::render
