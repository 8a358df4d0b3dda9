// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/clean_up/canonical_labels.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "segmentation/math/no_index.hpp"

namespace cleave::segmentation {
namespace {

using Labels = std::vector<std::uint16_t>;

Labels order(const std::vector<std::uint32_t>& segment_of_point, std::size_t segments) {
  std::vector<PointRun> runs;
  for (std::uint32_t i = 0; i < segment_of_point.size(); ++i) {
    runs.push_back({.segment = segment_of_point[i], .begin = i, .end = i + 1});
  }
  std::vector<std::uint32_t> itself(segments);
  std::iota(itself.begin(), itself.end(), 0U);
  Labels labels;
  EXPECT_TRUE(LabelOrder().order(runs, itself, labels));
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

TEST(LabelOrder, CountsWhatHasJoinedAndGivesNoLabelToWhatIsDropped) {
  const std::vector<PointRun> runs = {{.segment = 0, .begin = 0, .end = 3},
                                      {.segment = 1, .begin = 3, .end = 5},
                                      {.segment = 2, .begin = 5, .end = 7},
                                      {.segment = 3, .begin = 7, .end = 8}};
  Labels labels;

  ASSERT_TRUE(LabelOrder().order(runs, {0, 2, 2, no_index}, labels));

  EXPECT_EQ(labels, (Labels{2, 1, 1, 0}));
}

TEST(LabelOrder, RefusesMoreSegmentsThanLabelsCanName) {
  std::vector<PointRun> runs;
  std::vector<std::uint32_t> itself;
  for (std::uint32_t i = 0; i < max_labels; ++i) {
    runs.push_back({.segment = i, .begin = i, .end = i + 1});
    itself.push_back(i);
  }
  itself.push_back(max_labels);  // without a point
  Labels labels;

  EXPECT_TRUE(LabelOrder().order(runs, itself, labels));
  EXPECT_EQ(labels[max_labels - 1], max_labels);
  runs.push_back({.segment = max_labels, .begin = max_labels, .end = max_labels + 1});
  EXPECT_FALSE(LabelOrder().order(runs, itself, labels));
  EXPECT_EQ(labels, Labels(itself.size(), 0));
}

}  // namespace
}  // namespace cleave::segmentation
