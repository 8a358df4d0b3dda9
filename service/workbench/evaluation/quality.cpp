// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/evaluation/quality.hpp"

#include <algorithm>
#include <vector>

#include "workbench/evaluation/nearest_label.hpp"
#include "workbench/evaluation/overlaps.hpp"
#include "workbench/evaluation/partners.hpp"

namespace cleave::evaluation {
namespace {

constexpr double object_iou = 0.75;

void judge_covering(const Overlaps& o, Quality& quality) {
  for (std::size_t row = 0; row < o.true_segments(); ++row) {
    double best = 0;
    for (std::size_t column = 0; column < o.found_segments(); ++column) {
      best = std::max(best, o.iou(row, column));
    }
    quality.weighted_covering += best * o.truth_size[row] / o.points;
    quality.unweighted_covering += best / static_cast<double>(o.true_segments());
  }
}

// Above an intersection over union of one half a segment has at most one partner.
void judge_objects(const Overlaps& o, Quality& quality) {
  double partners = 0;
  for (std::size_t row = 0; row < o.true_segments(); ++row) {
    for (std::size_t column = 0; column < o.found_segments(); ++column) {
      partners += o.iou(row, column) > object_iou ? 1 : 0;
    }
  }
  if (partners == 0) return;
  const auto found = static_cast<double>(o.found_segments());
  const auto truth = static_cast<double>(o.true_segments());
  quality.object_precision = partners / found;
  quality.object_recall = partners / truth;
  quality.object_f = 2 * partners / (found + truth);
}

}  // namespace

Quality judge(std::span<const std::uint32_t> truth, std::span<const std::uint16_t> found) {
  const Overlaps o = count_overlaps(truth, found);
  Quality quality;
  if (o.points == 0) return quality;
  judge_covering(o, quality);
  const std::vector<std::size_t> partner = partners(o);
  const auto unmatched = std::ranges::count(partner, no_partner);
  const auto matches = static_cast<std::uint32_t>(std::ssize(partner) - unmatched);
  quality.true_segments = static_cast<std::uint32_t>(o.true_segments());
  quality.found_segments = static_cast<std::uint32_t>(o.found_segments());
  quality.under = quality.true_segments - matches;
  quality.over = quality.found_segments - matches;
  judge_objects(o, quality);
  return quality;
}

Quality judge(const LabelledCloud& cloud, std::span<std::uint16_t> found) {
  label_unlabelled(cloud.view(), found);
  return judge(cloud.label, found);
}

}  // namespace cleave::evaluation
