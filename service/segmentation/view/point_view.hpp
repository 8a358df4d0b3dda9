// Finds from where a cloud that is no image has to be looked at.
#pragma once

#include "segmentation/cloud_view.hpp"
#include "segmentation/options.hpp"
#include "segmentation/view/sight.hpp"
#include "segmentation/view/view.hpp"

namespace cleave::segmentation {

class PointViewFinder {
 public:
  // From the pose, if there is one; else, with Viewpoint::automatic, from the origin, or from above
  // (z, as for robots and in maps) where fewer points hide others from there. With
  // Viewpoint::automatic a cloud is taken as from one viewpoint if its points are more even as seen
  // from there than they are in metres.
  [[nodiscard]] View find(const CloudView& cloud, Viewpoint viewpoint);

 private:
  SightedPoints points_;
};

}  // namespace cleave::segmentation
