#include "cleave/evaluation/labelled_cloud.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "recording/pcd/cloud.hpp"
#include "recording/units/suspected_unit.hpp"

namespace cleave::evaluation {

LabelledCloud load_cloud(const std::filesystem::path& file, std::optional<recording::Unit> unit) {
  const auto pcd = recording::PcdCloud::read(file);
  LabelledCloud cloud{.width = pcd.header().width,
                      .height = pcd.header().height,
                      .xyz = {pcd.xyz().begin(), pcd.xyz().end()},
                      .label = pcd.labels()};
  for (std::size_t i = 0; i < cloud.label.size(); ++i) {
    const float* p = &cloud.xyz[3 * i];
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) cloud.label[i] = 0;
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
                             ": no finite point has a label other than 0, so nothing can be "
                             "judged by it");
  }
  return cloud;
}

}  // namespace cleave::evaluation
