// SPDX-License-Identifier: BSD-3-Clause
// cleave-render: rendered scenes as labelled PCD files.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>

#include "idl/topics.hpp"
#include "sensor/renderer/labelled_pcd.hpp"
#include "sensor/renderer/scene/scene_loop.hpp"

namespace {

using namespace cleave::render;

constexpr char examples[] =
    "SCENE is a name and keys as in the source of cleave-grabber: "
    "PRESET[?KEY=VALUE[&KEY=VALUE]...]\n"
    "with the presets simple, medium and crowded and the keys seed, objects, noise, width and "
    "height,\n"
    "with or without synthetic: before it. Files are named after the preset and the seed: "
    "crowded1.pcd.\n"
    "They are organised and hold x, y, z (metres) and label (uint32, 0 = none); the same SCENE\n"
    "gives the same bytes.\n"
    "\n"
    "Examples:\n"
    "  cleave-render crowded scenes                              crowded1.pcd\n"
    "  cleave-render 'synthetic:crowded?seed=1' --count 200 scenes\n"
    "  cleave-render crowded --count 20 --scale 2 scenes4x       4 times the points\n"
    "\n"
    "Ends with 0 when it is done, 1 when it failed, 2 for wrong usage.\n";

struct Settings {
  std::string scene;
  std::string folder;
  std::uint32_t count = 1;
  double scale = 1;
};

SceneRequest request_of(const Settings& settings) {
  constexpr std::string_view prefix = "synthetic:";
  std::string_view scene = settings.scene;
  if (scene.starts_with(prefix)) scene.remove_prefix(prefix.size());
  SceneRequest request = parse_scene(scene);
  if (request.seed > std::numeric_limits<std::uint32_t>::max() - (settings.count - 1)) {
    throw std::invalid_argument("there are no " + std::to_string(settings.count) + " seeds from " +
                                std::to_string(request.seed) + " on; start with a smaller seed");
  }
  return request;
}

void show_progress(std::uint32_t done, std::uint32_t count) {
  if (count == 0 || isatty(STDERR_FILENO) == 0) return;
  constexpr std::uint32_t columns = 40;
  const auto filled = static_cast<std::uint32_t>(std::uint64_t{columns} * done / count);
  std::cerr << "\r[" << std::string(filled, '#') << std::string(columns - filled, '.') << "] "
            << done << '/' << count << (done == count ? "\n" : "") << std::flush;
}

void render_all(const Settings& settings, SceneRequest request) {
  const CameraModel camera = scaled(camera_of_size(request.width, request.height), settings.scale);
  std::filesystem::create_directories(settings.folder);
  for (std::uint32_t i = 0; i < settings.count; ++i, ++request.seed) {
    show_progress(i, settings.count);
    const auto file = std::filesystem::path(settings.folder) /
                      (request.preset + std::to_string(request.seed) + ".pcd");
    write_labelled_pcd(file, SceneLoop(request, camera).frame(0), camera.intrinsics);
  }
  show_progress(settings.count, settings.count);
}

int run(int argc, char** argv) {
  CLI::App app("Renders table-top scenes as a depth camera sees them, with true labels.",
               "cleave-render");
  app.footer(examples);
  app.set_version_flag("--version", cleave::version_text(CLEAVE_VERSION));
  Settings settings;
  app.add_option("SCENE", settings.scene, "what to render, as below")->required();
  app.add_option("FOLDER", settings.folder, "where the files go; made if it is not there")
      ->required();
  app.add_option("--count", settings.count, "so many scenes, with the seeds from SCENE's on")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  app.add_option("--scale", settings.scale,
                 "columns and rows times this: 2 gives 4 times the points")
      ->check(CLI::Range(0.25, 4.0))
      ->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  SceneRequest request;
  try {
    request = request_of(settings);
  } catch (const std::invalid_argument& error) {
    std::cerr << "cleave-render: " << error.what() << '\n';
    return 2;
  }
  render_all(settings, request);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "cleave-render: " << error.what() << '\n';
    return 1;
  }
}
