// SPDX-License-Identifier: BSD-3-Clause
// Finds from where a cloud that is no image has to be looked at.
#pragma once

#include <Eigen/Core>

#include "segmentation/cloud_view.hpp"
#include "segmentation/options.hpp"
#include "segmentation/view/sight.hpp"
#include "segmentation/view/view.hpp"

namespace cleave::segmentation {

class PointViewFinder {
 public:
  // From the pose, if there is one, or else from the origin. Viewpoint::automatic: a cloud is from
  // one viewpoint if its points are more even as seen from there than they are in metres. If they
  // are not and there is no pose, normals may have to point elsewhere: from the origin many points
  // hide others, or it is far off, then they point up (z, as for robots and in maps).
  [[nodiscard]] View find(const CloudView& cloud, Viewpoint viewpoint);

 private:
  [[nodiscard]] bool is_sampled_from(const View& view, const Sight& sight) const;
  [[nodiscard]] Eigen::Vector3d likely_place(const Eigen::Vector3d& origin, const Sight& sight);

  SightedPoints points_;
};

}  // namespace cleave::segmentation
