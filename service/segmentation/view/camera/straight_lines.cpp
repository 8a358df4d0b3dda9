// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/view/camera/straight_lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "segmentation/view/middle.hpp"

namespace cleave::segmentation {

bool StraightLines::are_straight() {
  constexpr double near_px = 1.5;
  constexpr double most = 0.98;
  constexpr std::size_t min_pixels = 4;  // fewer tell nothing of a line
  constexpr double min_share = 0.5;      // of all pixels, in lines that tell
  std::size_t all = 0, judged = 0, near = 0;
  double last = -std::numeric_limits<double>::infinity();
  for (std::vector<double>& line : seen_) {
    all += line.size();
    if (line.size() < min_pixels) continue;
    judged += line.size();
    const double middle = median_of(line);
    if (!(middle > last)) return false;
    last = middle;
    near += static_cast<std::size_t>(std::count_if(
        line.begin(), line.end(), [&](double at) { return std::abs(at - middle) <= near_px; }));
  }
  return judged > 0 && static_cast<double>(judged) >= min_share * static_cast<double>(all) &&
         static_cast<double>(near) >= most * static_cast<double>(judged);
}

}  // namespace cleave::segmentation
