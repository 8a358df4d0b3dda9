#include "segmentation/canonical_labels.hpp"

#include <gtest/gtest.h>

namespace cleave::segmentation {
namespace {

using Labels = std::vector<std::uint16_t>;

Labels order(const std::vector<std::uint32_t>& segment_of_point, std::size_t segments) {
  std::vector<PointRun> runs;
  for (std::uint32_t i = 0; i < segment_of_point.size(); ++i) {
    runs.push_back({.segment = segment_of_point[i], .begin = i, .end = i + 1});
  }
  Labels labels;
  LabelOrder().order(runs, segments, labels);
  return labels;
}

TEST(LabelOrder, GivesOneToTheLargestSegment) {
  EXPECT_EQ(order({2, 0, 0, 1, 1, 1}, 3), (Labels{2, 1, 3}));
}

TEST(LabelOrder, BreaksTiesByTheLowestPoint) {
  EXPECT_EQ(order({1, 0, 0, 1}, 2), (Labels{2, 1}));
}

TEST(LabelOrder, GivesASegmentWithoutPointsNoLabel) {
  EXPECT_EQ(order({3, 3}, 4), (Labels{0, 0, 0, 1}));
}

TEST(LabelOrder, LetsTheSmallestSegmentsShareTheLastLabel) {
  std::vector<std::uint32_t> points;
  for (std::uint32_t i = 0; i < max_labels + 5; ++i) points.push_back(i);

  const Labels labels = order(points, points.size());

  EXPECT_EQ(labels.front(), 1);
  EXPECT_EQ(labels[max_labels - 1], max_labels);
  EXPECT_EQ(labels.back(), max_labels);
}

}  // namespace
}  // namespace cleave::segmentation
