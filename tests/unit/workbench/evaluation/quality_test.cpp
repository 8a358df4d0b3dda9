// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/evaluation/quality.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace cleave::evaluation {
namespace {

TEST(Judge, GivesOneToAPerfectSegmentation) {
  const std::vector<std::uint32_t> truth = {20, 20, 1, 1, 1, 0};
  const std::vector<std::uint16_t> found = {2, 2, 1, 1, 1, 9};

  const Quality quality = judge(truth, found);

  EXPECT_DOUBLE_EQ(quality.weighted_covering, 1);
  EXPECT_DOUBLE_EQ(quality.unweighted_covering, 1);
  EXPECT_EQ(quality.under, 0U);
  EXPECT_EQ(quality.over, 0U);
}

TEST(Judge, WorksOutEquations5_2And5_3) {
  // Truth: 6 and 2 points. Found: 5 of the first; the sixth together with the second.
  const std::vector<std::uint32_t> truth = {1, 1, 1, 1, 1, 1, 2, 2};
  const std::vector<std::uint16_t> found = {1, 1, 1, 1, 1, 2, 2, 2};

  const Quality quality = judge(truth, found);

  EXPECT_NEAR(quality.weighted_covering, (6 * 5.0 / 6 + 2 * 2.0 / 3) / 8, 1e-12);
  EXPECT_NEAR(quality.unweighted_covering, (5.0 / 6 + 2.0 / 3) / 2, 1e-12);
}

TEST(Judge, CountsUnderAndOverSegmentation) {
  const std::vector<std::uint32_t> truth = {1, 1, 2, 2, 3, 3, 3};
  const std::vector<std::uint16_t> merged = {1, 1, 1, 1, 2, 2, 2};
  const std::vector<std::uint16_t> split = {1, 1, 2, 2, 3, 4, 4};

  EXPECT_EQ(judge(truth, merged).under, 1U);
  EXPECT_EQ(judge(truth, merged).over, 0U);
  EXPECT_EQ(judge(truth, split).under, 0U);
  EXPECT_EQ(judge(truth, split).over, 1U);
}

// The kinds of segmentation that Table 5.1 tells apart (Figures 5.7a and 5.8), on a scene of 20
// points: a table of 12, boxes of 4 and 2, and a cup of 2.
class JudgeTable5_1 : public testing::Test {
 protected:
  const std::vector<std::uint32_t> truth_ = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
                                             1, 1, 2, 2, 2, 2, 3, 3, 4, 4};
};

TEST_F(JudgeTable5_1, PerfectButForAPointOnABorder) {
  // The table has lost one of its 12 points to the first box: 11/12 and 4/5.
  const Quality quality = judge(truth_, std::vector<std::uint16_t>{1, 1, 1, 1, 1, 1, 1, 1, 1, 1,  //
                                                                   1, 2, 2, 2, 2, 2, 3, 3, 4, 4});

  EXPECT_NEAR(quality.weighted_covering, (12 * 11.0 / 12 + 4 * 4.0 / 5 + 2 + 2) / 20, 1e-12);
  EXPECT_NEAR(quality.unweighted_covering, (11.0 / 12 + 4.0 / 5 + 1 + 1) / 4, 1e-12);
  EXPECT_EQ(quality.under, 0U);
  EXPECT_EQ(quality.over, 0U);
}

TEST_F(JudgeTable5_1, MildUnderSegmentationHurtsTheUnweightedCoveringMore) {
  // The two boxes are one segment (4/6, 2/6), and the cup is part of the table (12/14, 2/14).
  const Quality quality = judge(truth_, std::vector<std::uint16_t>{1, 1, 1, 1, 1, 1, 1, 1, 1, 1,  //
                                                                   1, 1, 2, 2, 2, 2, 2, 2, 1, 1});

  EXPECT_NEAR(quality.weighted_covering,
              (12 * 12.0 / 14 + 4 * 4.0 / 6 + 2 * 2.0 / 6 + 2 * 2.0 / 14) / 20, 1e-12);
  EXPECT_NEAR(quality.unweighted_covering, (12.0 / 14 + 4.0 / 6 + 2.0 / 6 + 2.0 / 14) / 4, 1e-12);
  EXPECT_EQ(quality.under, 2U);
  EXPECT_EQ(quality.over, 0U);
}

TEST_F(JudgeTable5_1, MildOverSegmentation) {
  // The boxes fall into two parts each: 3/4 and 1/2 are the best.
  const Quality quality = judge(truth_, std::vector<std::uint16_t>{1, 1, 1, 1, 1, 1, 1, 1, 1, 1,  //
                                                                   1, 1, 2, 2, 2, 5, 3, 6, 4, 4});

  EXPECT_NEAR(quality.weighted_covering, (12 + 4 * 3.0 / 4 + 2 * 1.0 / 2 + 2) / 20, 1e-12);
  EXPECT_NEAR(quality.unweighted_covering, (1 + 3.0 / 4 + 1.0 / 2 + 1) / 4, 1e-12);
  EXPECT_EQ(quality.under, 0U);
  EXPECT_EQ(quality.over, 2U);
}

TEST_F(JudgeTable5_1, AnExtremelyBadResult) {
  // The table falls into 7 and 5 points; boxes and cup are one segment of 8. Two true segments find
  // no partner; one half of the table does not either.
  const Quality quality = judge(truth_, std::vector<std::uint16_t>{1, 1, 1, 1, 1, 1, 1, 5, 5, 5,  //
                                                                   5, 5, 2, 2, 2, 2, 2, 2, 2, 2});

  EXPECT_NEAR(quality.weighted_covering,
              (12 * 7.0 / 12 + 4 * 4.0 / 8 + 2 * 2.0 / 8 + 2 * 2.0 / 8) / 20, 1e-12);
  EXPECT_NEAR(quality.unweighted_covering, (7.0 / 12 + 4.0 / 8 + 2.0 / 8 + 2.0 / 8) / 4, 1e-12);
  EXPECT_EQ(quality.under, 2U);
  EXPECT_EQ(quality.over, 1U);
}

TEST(Judge, TakesAnUnlabelledPointForNoSegment) {
  const Quality quality = judge(std::vector<std::uint32_t>{1, 1}, std::vector<std::uint16_t>{0, 1});

  EXPECT_DOUBLE_EQ(quality.weighted_covering, 0.5);
}

TEST(Judge, CountsObjectsThatAreCoveredToThreeQuarters) {
  // Truth: 8, 4 and 4 points. Found: 7 of the first (7/8); the second whole, with one more (4/5);
  // the third in halves (2/4).
  const std::vector<std::uint32_t> truth = {1, 1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
  const std::vector<std::uint16_t> found = {1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 3, 3, 4, 4};

  const Quality quality = judge(truth, found);

  EXPECT_DOUBLE_EQ(quality.object_precision, 2.0 / 4);
  EXPECT_DOUBLE_EQ(quality.object_recall, 2.0 / 3);
  EXPECT_DOUBLE_EQ(quality.object_f, 2 * (2.0 / 4) * (2.0 / 3) / (2.0 / 4 + 2.0 / 3));
}

TEST(Judge, GivesZeroWhereNothingIsFoundOrNothingIsTrue) {
  const std::vector<std::uint32_t> truth = {1, 2};
  const std::vector<std::uint16_t> none = {0, 0};

  EXPECT_DOUBLE_EQ(judge(truth, none).weighted_covering, 0);
  EXPECT_EQ(judge(truth, none).under, 2U);
  EXPECT_DOUBLE_EQ(judge(truth, none).object_f, 0);
  EXPECT_DOUBLE_EQ(judge(std::vector<std::uint32_t>{0, 0}, none).weighted_covering, 0);
}

}  // namespace
}  // namespace cleave::evaluation
