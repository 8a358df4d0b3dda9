// The SCENE in a source's name `synthetic:SCENE`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace cleave::render {

// SCENE = PRESET[?KEY=VALUE[&KEY=VALUE]...], for example crowded?seed=3&motion=1.
struct SceneRequest {
  std::string preset;                    // simple, medium or crowded
  std::uint32_t seed = 1;                // of the scene and its noise
  std::optional<std::uint32_t> objects;  // exactly so many instead of the preset's range, 2 to 30
  std::uint32_t frames = 8;              // in the loop, 1 to 600; 60 unless given when in motion
  bool motion = false;                   // whether the camera moves
  bool noise = true;                     // false: exact depth, rounded to 1 mm
  std::uint32_t fps = 30;                // 1 to 240
};

// Throws std::invalid_argument for an unknown preset or key, a value that is not a whole number
// within its range, and a key that is given twice; the text names it, says what is known, and gives
// an example.
[[nodiscard]] SceneRequest parse_scene(std::string_view text);

}  // namespace cleave::render
