#include "cleave/evaluation/quality.hpp"

#include <algorithm>

#include "cleave/evaluation/assignment.hpp"
#include "cleave/evaluation/overlaps.hpp"

namespace cleave::evaluation {
namespace {

constexpr double object_iou = 0.75;

std::vector<std::vector<double>> transposed(const std::vector<std::vector<double>>& matrix) {
  std::vector<std::vector<double>> result(matrix.front().size());
  for (const auto& row : matrix) {
    for (std::size_t c = 0; c < row.size(); ++c) result[c].push_back(row[c]);
  }
  return result;
}

std::uint32_t count_matches(const std::vector<std::vector<double>>& common) {
  if (common.empty() || common.front().empty()) return 0;
  const auto gain = common.size() <= common.front().size() ? common : transposed(common);
  const auto column = best_assignment(gain);
  std::uint32_t matches = 0;
  for (std::size_t row = 0; row < gain.size(); ++row) matches += gain[row][column[row]] > 0 ? 1 : 0;
  return matches;
}

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
  const std::uint32_t matches = count_matches(o.common);
  quality.under = static_cast<std::uint32_t>(o.true_segments()) - matches;
  quality.over = static_cast<std::uint32_t>(o.found_segments()) - matches;
  judge_objects(o, quality);
  return quality;
}

}  // namespace cleave::evaluation
