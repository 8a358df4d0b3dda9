// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/renderer/scene/scene_uri.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "sensor/renderer/scene/scene.hpp"

namespace cleave::render {
namespace {

constexpr std::uint32_t default_frames_in_motion = 60;

// One row for each key: all that the parser and its messages know about it.
struct Key {
  std::string_view name;
  std::uint32_t low, high;
  void (*set)(SceneRequest&, std::uint32_t);
};
constexpr std::uint32_t longest_ms = 3'600'000;
constexpr std::array<Key, 18> keys = {{
    {"seed", 0, std::numeric_limits<std::uint32_t>::max(),
     [](SceneRequest& request, std::uint32_t value) { request.seed = value; }},
    {"objects", fewest_objects, most_objects,
     [](SceneRequest& request, std::uint32_t value) { request.objects = value; }},
    {"frames", 1, 600, [](SceneRequest& request, std::uint32_t value) { request.frames = value; }},
    {"motion", 0, 1,
     [](SceneRequest& request, std::uint32_t value) { request.motion = value != 0; }},
    {"noise", 0, 1, [](SceneRequest& request, std::uint32_t value) { request.noise = value != 0; }},
    {"fps", 1, 240, [](SceneRequest& request, std::uint32_t value) { request.fps = value; }},
    {"width", 16, 1600, [](SceneRequest& request, std::uint32_t value) { request.width = value; }},
    {"height", 16, 1200,
     [](SceneRequest& request, std::uint32_t value) { request.height = value; }},
    {"mirrored", 0, 1,
     [](SceneRequest& request, std::uint32_t value) { request.mirrored = value != 0; }},
    {"registration", 0, 1,
     [](SceneRequest& request, std::uint32_t value) { request.registration = value != 0; }},
    {"unplug_at_ms", 1, longest_ms,
     [](SceneRequest& request, std::uint32_t value) { request.faults.unplug_at_ms = value; }},
    {"replug_after_ms", 1, longest_ms,
     [](SceneRequest& request, std::uint32_t value) { request.faults.replug_after_ms = value; }},
    {"stall_at_ms", 1, longest_ms,
     [](SceneRequest& request, std::uint32_t value) { request.faults.stall_at_ms = value; }},
    {"stall_ms", 1, longest_ms,
     [](SceneRequest& request, std::uint32_t value) { request.faults.stall_ms = value; }},
    {"in_use_ms", 1, longest_ms,
     [](SceneRequest& request, std::uint32_t value) { request.faults.in_use_ms = value; }},
    {"clock_reset_at_ms", 1, longest_ms,
     [](SceneRequest& request, std::uint32_t value) { request.faults.clock_reset_at_ms = value; }},
    {"drop_at_ms", 1, longest_ms,
     [](SceneRequest& request, std::uint32_t value) { request.faults.drop_at_ms = value; }},
    {"drop_frames", 1, 1000,
     [](SceneRequest& request, std::uint32_t value) { request.faults.drop_frames = value; }},
}};

std::string quoted(std::string_view text) {
  return '"' + std::string(text) + '"';
}

[[noreturn]] void refuse(std::string_view text, const std::string& why) {
  throw std::invalid_argument("cannot use the synthetic scene " + quoted(text) + ": " + why +
                              "; an example is crowded?seed=3&motion=1");
}

std::string known_presets() {
  std::string list;
  for (const std::string_view name : preset_names()) {
    list += (list.empty() ? "" : ", ") + std::string(name);
  }
  return list;
}

std::string known_keys() {
  std::string list;
  for (const Key& key : keys) {
    list += (list.empty() ? "" : ", ") + std::string(key.name) + " (" + std::to_string(key.low) +
            " to " + std::to_string(key.high) + ")";
  }
  return list;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> items;
  while (true) {
    const std::size_t end = text.find(separator);
    items.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return items;
    text.remove_prefix(end + 1);
  }
}

std::uint32_t parse_value(std::string_view text, const Key& key, std::string_view value) {
  std::uint32_t number = 0;
  const char* const end = value.data() + value.size();
  const auto result = std::from_chars(value.data(), end, number);
  if (result.ec != std::errc() || result.ptr != end || number < key.low || number > key.high) {
    refuse(text, std::string(key.name) + " is " + quoted(value) + ", not a whole number from " +
                     std::to_string(key.low) + " to " + std::to_string(key.high));
  }
  return number;
}

}  // namespace

SceneRequest parse_scene(std::string_view text) {
  const std::size_t question = text.find('?');
  SceneRequest request;
  request.preset = text.substr(0, question);
  if (std::ranges::find(preset_names(), request.preset) == preset_names().end()) {
    refuse(text, "unknown scene " + quoted(request.preset) + ", known are " + known_presets());
  }
  if (question == std::string_view::npos) return request;

  std::vector<std::string_view> given;
  for (const std::string_view item : split(text.substr(question + 1), '&')) {
    const std::size_t equals = item.find('=');
    const std::string_view name = item.substr(0, equals);
    const auto* const key = std::ranges::find(keys, name, &Key::name);
    if (key == keys.end()) {
      refuse(text, "unknown key " + quoted(name) + ", known are " + known_keys());
    }
    if (equals == std::string_view::npos) refuse(text, quoted(name) + " has no value");
    if (std::ranges::find(given, name) != given.end()) refuse(text, quoted(name) + " stands twice");
    given.push_back(name);
    key->set(request, parse_value(text, *key, item.substr(equals + 1)));
  }
  const bool frames_given = std::ranges::find(given, "frames") != given.end();
  if (request.motion && !frames_given) request.frames = default_frames_in_motion;
  return request;
}

}  // namespace cleave::render
