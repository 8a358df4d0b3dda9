// SPDX-License-Identifier: BSD-3-Clause
#include "tests/unit/workbench/trials/labelled_folder.hpp"

#include "recording/pcd/folder.hpp"
#include "recording/pcd/writer.hpp"
#include "tests/support/box_scene.hpp"

namespace cleave::workbench {
namespace {

void write(const std::filesystem::path& file, const evaluation::LabelledCloud& cloud) {
  auto pcd = recording::PcdCloud::of_points(cloud.xyz, cloud.width, cloud.height);
  if (cloud.labelled()) {
    pcd.set_labels(std::vector<std::uint16_t>(cloud.label.begin(), cloud.label.end()));
  }
  recording::write_pcd(file, pcd);
}

}  // namespace

LabelledFolder::LabelledFolder() {
  evaluation::LabelledCloud scene = tests::render_touching_boxes();
  write(path() / "scene1.pcd", scene);
  evaluation::LabelledCloud points = scene;
  points.width *= points.height;
  points.height = 1;
  write(path() / "scene2.pcd", points);
  for (std::uint32_t& label : scene.label) label = label == 1 ? 1 : 0;
  write(path() / "scene10.pcd", scene);
}

std::vector<std::filesystem::path> LabelledFolder::files() const {
  return recording::pcd_files(path());
}

void LabelledFolder::add_unlabelled(const std::string& name) const {
  evaluation::LabelledCloud scene = tests::render_touching_boxes(160, 120);
  scene.label.clear();
  write(path() / name, scene);
}

}  // namespace cleave::workbench
