#include "cleave/evaluation/quality.hpp"

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
