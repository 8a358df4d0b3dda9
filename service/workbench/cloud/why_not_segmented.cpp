// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/cloud/why_not_segmented.hpp"

namespace cleave::workbench {

std::string_view why_not_segmented(segmentation::Outcome outcome) {
  switch (outcome) {
    case segmentation::Outcome::no_finite_point:
      return "no point has coordinates that are finite and not all 0; there is nothing to segment";
    case segmentation::Outcome::bad_size:
      return "the segmentation takes no cloud of this size";
    case segmentation::Outcome::too_many_segments:
      return "falls into more than 65535 segments, which is all that labels can name; set "
             "clean_up.min_segment_points, or a larger voxel.size_m and "
             "supervoxel.seed_spacing_m";
    case segmentation::Outcome::segmented:
      break;
  }
  return "";
}

}  // namespace cleave::workbench
