// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/evaluation/boundary.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace cleave::evaluation {
namespace {

constexpr std::uint32_t width = 8;

// Rows of 8 pixels whose label changes behind each of the columns given.
template <typename Label>
std::vector<Label> stripes(const std::vector<std::uint32_t>& last_columns, std::uint32_t rows = 3) {
  std::vector<Label> labels;
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t column = 0; column < width; ++column) {
      Label label = 1;
      for (const std::uint32_t last : last_columns) label = Label(label + (column > last ? 1 : 0));
      labels.push_back(label);
    }
  }
  return labels;
}

const auto truth_of = stripes<std::uint32_t>;
const auto found_of = stripes<std::uint16_t>;

TEST(JudgeBoundaries, ForgivesWhatTheToleranceCovers) {
  const auto truth = truth_of({3}, 3);
  const auto found = found_of({5}, 3);

  EXPECT_DOUBLE_EQ(judge_boundaries(width, truth, found, 2).f, 1);
  EXPECT_DOUBLE_EQ(judge_boundaries(width, truth, found, 1).f, 0);
}

TEST(JudgeBoundaries, WorksOutPrecisionAndRecall) {
  // True borders at columns 1 and 6, found ones at 1, 3 and 4: one of three is right, one of two
  // is found.
  const BoundaryScore score =
      judge_boundaries(width, truth_of({1, 6}, 3), found_of({1, 3, 4}, 3), 1);

  EXPECT_DOUBLE_EQ(score.precision, 1.0 / 3);
  EXPECT_DOUBLE_EQ(score.recall, 1.0 / 2);
  EXPECT_DOUBLE_EQ(score.f, 2 * (1.0 / 3) * (1.0 / 2) / (1.0 / 3 + 1.0 / 2));
}

TEST(JudgeBoundaries, MeasuresDistancesInAllDirections) {
  // 3 x 3 pixels. True border: row 0, column 0. Found: row 1, column 2 and row 2, column 1. Both
  // are sqrt(5) away.
  const std::vector<std::uint32_t> truth = {2, 1, 1, 1, 1, 1, 1, 1, 1};
  const std::vector<std::uint16_t> found = {1, 1, 1, 1, 1, 1, 1, 1, 2};

  EXPECT_DOUBLE_EQ(judge_boundaries(3, truth, found, 2).f, 0);
  EXPECT_DOUBLE_EQ(judge_boundaries(3, truth, found, 3).f, 1);
}

TEST(JudgeBoundaries, LeavesOutPixelsWithoutATruth) {
  auto truth = truth_of({3}, 3);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (i % width == 5) truth[i] = 0;
  }

  EXPECT_DOUBLE_EQ(judge_boundaries(width, truth, found_of({3, 5}, 3), 1).precision, 1);
}

TEST(JudgeBoundaries, AgreesThatThereIsNone) {
  EXPECT_DOUBLE_EQ(judge_boundaries(width, truth_of({}, 3), found_of({}, 3), 1).f, 1);
  EXPECT_DOUBLE_EQ(judge_boundaries(width, truth_of({3}, 3), found_of({}, 3), 1).f, 0);
  EXPECT_DOUBLE_EQ(judge_boundaries(width, truth_of({}, 3), found_of({3}, 3), 1).f, 0);
}

TEST(BoundaryTolerance, IsEightThousandthsOfTheDiagonal) {
  EXPECT_EQ(boundary_tolerance_px(640, 480), 6U);
  EXPECT_EQ(boundary_tolerance_px(10, 10), 1U);
}

// A plane of 64 x 48 points at 1 m, its left half one segment.
LabelledCloud two_halves() {
  LabelledCloud cloud{.width = 64, .height = 48, .xyz = {}, .label = {}};
  for (int row = 0; row < 48; ++row) {
    for (int column = 0; column < 64; ++column) {
      cloud.xyz.insert(cloud.xyz.end(), {0.01F * static_cast<float>(column - 32),
                                         0.01F * static_cast<float>(row - 24), 1.0F});
      cloud.label.push_back(column < 32 ? 4 : 9);
    }
  }
  return cloud;
}

TEST(JudgeBoundaries, JudgesACloudThatIsNoImageByItsProjection) {
  LabelledCloud cloud = two_halves();
  std::vector<std::uint16_t> right(cloud.label.begin(), cloud.label.end());
  const std::vector<std::uint16_t> merged(cloud.size(), 1);
  cloud.width *= cloud.height;
  cloud.height = 1;

  EXPECT_DOUBLE_EQ(judge_boundaries(cloud, right).f, 1);
  EXPECT_DOUBLE_EQ(judge_boundaries(cloud, merged).f, 0);
  for (std::size_t i = 0; i < right.size(); ++i) right[i] = i % 64 < 42 ? 1 : 2;  // far beside it
  EXPECT_LT(judge_boundaries(cloud, right).f, 0.2);
}

TEST(JudgeBoundaries, JudgesAnImageAsItIs) {
  const LabelledCloud cloud = two_halves();
  std::vector<std::uint16_t> found(cloud.label.begin(), cloud.label.end());

  EXPECT_DOUBLE_EQ(judge_boundaries(cloud, found).f, 1);
  for (std::size_t i = 0; i < found.size(); ++i) found[i] = i % 64 < 35 ? 1 : 2;
  EXPECT_DOUBLE_EQ(judge_boundaries(cloud, found).f, 0) << "1 pixel is near, 3 are not";
}

}  // namespace
}  // namespace cleave::evaluation
