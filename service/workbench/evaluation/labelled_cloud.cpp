// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/evaluation/labelled_cloud.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "recording/units/suspected_unit.hpp"
#include "segmentation/view/measured.hpp"
#include "workbench/cloud/pcd_view.hpp"

namespace cleave::evaluation {

LabelledCloud load_cloud(const std::filesystem::path& file, std::optional<recording::Unit> unit) {
  const auto pcd = recording::PcdCloud::read(file);
  const segmentation::CloudView view = workbench::view_in_metres(pcd, pcd.xyz(), unit);
  LabelledCloud cloud{.width = view.width,
                      .height = view.height,
                      .xyz = {pcd.xyz().begin(), pcd.xyz().end()},
                      .label = pcd.labels(),
                      .origin_m = view.origin_m,
                      .pose = view.pose};
  for (std::size_t i = 0; i < cloud.label.size(); ++i) {
    if (!segmentation::is_measured(view.point(i))) cloud.label[i] = 0;
  }
  recording::make_metres(cloud.xyz, unit, file.string());
  return cloud;
}

LabelledCloud load_labelled_cloud(const std::filesystem::path& file,
                                  std::optional<recording::Unit> unit) {
  LabelledCloud cloud = load_cloud(file, unit);
  if (!cloud.labelled()) {
    throw std::runtime_error(file.string() +
                             ": has no field label (uint32), so nothing can be judged by it");
  }
  if (std::ranges::all_of(cloud.label, [](std::uint32_t label) { return label == 0; })) {
    throw std::runtime_error(file.string() +
                             ": no measured point has a label other than 0, so nothing can be "
                             "judged by it");
  }
  return cloud;
}

}  // namespace cleave::evaluation
