#include "cleave/evaluation/labelled_cloud.hpp"

#include <cmath>

#include "cleave/cloud/pcd_cloud.hpp"

namespace cleave::evaluation {

LabelledCloud load_cloud(const std::filesystem::path& file) {
  const client::PcdCloud pcd = client::PcdCloud::read(file);
  const segmentation::CloudView view = pcd.view();
  LabelledCloud cloud{.width = view.width,
                      .height = view.height,
                      .xyz = {view.xyz, view.xyz + view.size() * view.stride},
                      .label = pcd.labels()};
  for (std::size_t i = 0; i < cloud.label.size(); ++i) {
    const float* p = view.point(i);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) cloud.label[i] = 0;
  }
  return cloud;
}

}  // namespace cleave::evaluation
