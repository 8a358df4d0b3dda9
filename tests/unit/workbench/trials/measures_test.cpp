// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/trials/measures.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace cleave::workbench {
namespace {

Run run_with(double covering, double milliseconds) {
  Run run;
  run.quality.weighted_covering = covering;
  run.milliseconds = milliseconds;
  return run;
}

std::vector<Scene> scenes() {
  std::vector<Scene> scenes(3);
  scenes[0].runs = {{run_with(0.5, 1), run_with(0.7, 2)}};
  scenes[1].problem = "unreadable";
  scenes[2].runs = {{run_with(0.9, 3), run_with(0.9, 4)}};
  return scenes;
}

TEST(Sample, HasTheMeanOfAllRunsAndTheWorstOfThem) {
  const auto all = scenes();

  const Sample sample = sample_of(all, 0);

  EXPECT_EQ(sample.scenes(), 2U);
  EXPECT_EQ(sample.runs(), 4U);
  const Spread spread = sample.spread_of(measure("weighted_covering"));
  EXPECT_DOUBLE_EQ(spread.mean, (0.5 + 0.7 + 0.9 + 0.9) / 4);
  EXPECT_DOUBLE_EQ(spread.min, 0.5);
  EXPECT_DOUBLE_EQ(spread.max, 0.9);
  EXPECT_DOUBLE_EQ(sample.milliseconds().median, 2);
}

TEST(Sample, OfAGroupLeavesTheOthersOut) {
  const auto all = scenes();

  EXPECT_DOUBLE_EQ(Sample(all, 0, {1, 2}).mean_of("weighted_covering"), 0.9);
  EXPECT_EQ(Sample(all, 0, {1, 1}).runs(), 0U);
}

TEST(Measure, IsFoundByItsKeyOnly) {
  EXPECT_EQ(measure("object_f").key, "object_f");
  EXPECT_THROW((void)measure("beauty"), std::out_of_range);
}

}  // namespace
}  // namespace cleave::workbench
