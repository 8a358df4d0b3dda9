// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/result_check.hpp"

#include <cstddef>
#include <cstdint>

namespace cleave::segmentation {

Doubt doubt_about(const Segmentation& result) {
  std::uint64_t labelled = 0;
  std::size_t single = 0;
  for (const Segment& segment : result.segments) {
    labelled += segment.point_count;
    if (segment.point_count == 1) ++single;
  }
  if (2 * labelled < result.measured_points) return Doubt::mostly_unlabelled;
  if (2 * single > result.segments.size()) return Doubt::mostly_single_points;
  return Doubt::none;
}

std::string_view advice_on(Doubt doubt) {
  switch (doubt) {
    case Doubt::none:
      return "";
    case Doubt::mostly_unlabelled:
      return "most points have no segment: what they were made into is smaller than "
             "clean_up.min_segment_points; if the cloud is sparse, set voxel.size_m to about 1.6 "
             "times the distance of its points and supervoxel.seed_spacing_m to 4 times that, if "
             "not in metres, its unit";
    case Doubt::mostly_single_points:
      return "most segments are single points: set voxel.size_m to about 1.6 times the distance of "
             "the cloud's points and supervoxel.seed_spacing_m to 4 times that, or "
             "clean_up.min_segment_points to drop them";
  }
  return "";
}

}  // namespace cleave::segmentation
