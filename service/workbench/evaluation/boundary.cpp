// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/evaluation/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "console/picture/depth_image.hpp"
#include "workbench/cloud/points_view.hpp"
#include "workbench/evaluation/partners.hpp"

namespace cleave::evaluation {
namespace {

using Mask = std::vector<std::uint8_t>;

template <typename Label>
Mask borders_of(std::uint32_t width, std::span<const std::uint32_t> truth,
                std::span<const Label> label) {
  Mask mask(label.size(), 0);
  for (std::size_t i = 0; i < label.size(); ++i) {
    if (truth[i] == 0) continue;
    const auto differs = [&](std::size_t k) { return truth[k] != 0 && label[k] != label[i]; };
    const bool right = i % width + 1 < width && differs(i + 1);
    const bool below = i + width < label.size() && differs(i + width);
    mask[i] = right || below ? 1 : 0;
  }
  return mask;
}

// All pixels within `radius` of one of the mask's.
Mask dilated(const Mask& mask, std::uint32_t width, std::int64_t radius) {
  Mask result(mask.size(), 0);
  const auto columns = static_cast<std::int64_t>(width);
  const auto rows = static_cast<std::int64_t>(mask.size()) / columns;
  for (std::int64_t y = 0; y < rows; ++y) {
    for (std::int64_t x = 0; x < columns; ++x) {
      if (mask[static_cast<std::size_t>(y * columns + x)] == 0) continue;
      for (std::int64_t v = std::max<std::int64_t>(0, y - radius);
           v <= std::min(rows - 1, y + radius); ++v) {
        const auto reach = static_cast<std::int64_t>(
            std::sqrt(static_cast<double>(radius * radius - (v - y) * (v - y))));
        const std::int64_t left = std::max<std::int64_t>(0, x - reach);
        const std::int64_t right = std::min(columns - 1, x + reach);
        std::fill_n(&result[static_cast<std::size_t>(v * columns + left)], right - left + 1, 1);
      }
    }
  }
  return result;
}

double count(const Mask& mask) {
  return static_cast<double>(std::ranges::count(mask, 1));
}

double share_within(const Mask& mask, const Mask& area) {
  double within = 0;
  for (std::size_t i = 0; i < mask.size(); ++i) within += mask[i] & area[i];
  return within / count(mask);
}

}  // namespace

std::uint32_t boundary_tolerance_px(std::uint32_t width, std::uint32_t height) {
  constexpr double share_of_diagonal = 0.008;
  const double pixels = share_of_diagonal * std::hypot(width, height);
  return std::max(1U, static_cast<std::uint32_t>(std::lround(pixels)));
}

BoundaryScore judge_boundaries(std::uint32_t width, std::span<const std::uint32_t> truth,
                               std::span<const std::uint16_t> found, std::uint32_t tolerance_px) {
  const Mask true_border = borders_of(width, truth, truth);
  const Mask found_border = borders_of(width, truth, found);
  const bool any_true = count(true_border) > 0;
  const bool any_found = count(found_border) > 0;
  if (!any_true && !any_found) return {1, 1, 1};
  if (!any_true || !any_found) return {};

  BoundaryScore score;
  score.precision = share_within(found_border, dilated(true_border, width, tolerance_px));
  score.recall = share_within(true_border, dilated(found_border, width, tolerance_px));
  const double sum = score.precision + score.recall;
  score.f = sum > 0 ? 2 * score.precision * score.recall / sum : 0;
  return score;
}

BoundaryScore judge_boundaries(const LabelledCloud& cloud, std::span<const std::uint16_t> found) {
  if (cloud.view().organised()) {
    return judge_boundaries(cloud.width, cloud.label, found,
                            boundary_tolerance_px(cloud.width, cloud.height));
  }
  const PairedLabels paired = pair_labels(cloud.label, found);
  const ImageSize size = filled_size(cloud.size());
  const auto truth = depth_image(workbench::points_of(cloud.view()), paired.truth, size);
  const auto result = depth_image(workbench::points_of(cloud.view()), paired.found, size);
  return judge_boundaries(truth.width,
                          std::vector<std::uint32_t>(truth.label.begin(), truth.label.end()),
                          result.label, boundary_tolerance_px(truth.width, truth.height));
}

}  // namespace cleave::evaluation
