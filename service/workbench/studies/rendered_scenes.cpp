// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/studies/rendered_scenes.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "libcleave/process/companion.hpp"
#include "workbench/studies/program.hpp"

namespace cleave::workbench {
namespace {

constexpr std::uint32_t first_seed = 530001;  // section 5.3

void render(const std::filesystem::path& folder, const std::string& preset, std::uint32_t count) {
  const std::filesystem::path renderer =
      companion("cleave-render",
                "it renders the scenes: build the target of that name, or name a folder of "
                "labelled scenes");
  const std::string scene = "synthetic:" + preset + "?seed=" + std::to_string(first_seed);
  const std::vector<std::string> words{renderer, scene, folder, "--count", std::to_string(count)};
  if (run_program(words) == ProgramEnd::done) return;
  throw std::runtime_error(renderer.string() + " could not render scenes into " + folder.string() +
                           "; what it printed says why");
}

}  // namespace

std::vector<std::filesystem::path> rendered_scenes(const std::filesystem::path& folder,
                                                   const std::string& preset, std::uint32_t count) {
  std::vector<std::filesystem::path> files;
  for (std::uint32_t i = 0; i < count; ++i) {
    files.push_back(folder / (preset + std::to_string(first_seed + i) + ".pcd"));
  }
  const auto is_there = [](const auto& file) { return std::filesystem::exists(file); };
  if (!std::ranges::all_of(files, is_there)) render(folder, preset, count);
  return files;
}

}  // namespace cleave::workbench
