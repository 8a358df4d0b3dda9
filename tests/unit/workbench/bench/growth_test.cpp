// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/bench/growth.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/box_scene.hpp"

namespace cleave::workbench {
namespace {

TEST(FittedExponent, IsThePowerOfAPowerLaw) {
  EXPECT_NEAR(fitted_exponent({1, 4, 16}, {3, 6, 12}), 0.5, 1e-12);
  EXPECT_NEAR(fitted_exponent({10, 20, 40}, {5, 20, 80}), 2, 1e-12);
}

TEST(FittedExponent, IsTheSlopeOfTheBestLineThroughTheLogarithms) {
  // ln x = 0, 1, 2 and ln y = 0, 0, 3: slope 3/2.
  const double e = std::exp(1.0);
  EXPECT_NEAR(fitted_exponent({1, e, e * e}, {1, 1, e * e * e}), 1.5, 1e-12);
}

TEST(FittedExponent, IsZeroWhereThereIsNoLine) {
  EXPECT_EQ(fitted_exponent({5, 5}, {1, 2}), 0);
  EXPECT_EQ(fitted_exponent({1, 2}, {0, 2}), 0);
}

TEST(Growth, MeasuresThreeSizesOfEachCloud) {
  Growth growth{BenchPlan{}};

  growth.measure("boxes", tests::render_touching_boxes(160, 120));

  const Json json = growth.json();
  EXPECT_EQ(json["points"], (std::vector<double>{4800, 19200, 76800}));
  EXPECT_EQ(json["milliseconds"].size(), 3U);
  EXPECT_EQ(json["scenes"], 1);
  EXPECT_GT(json["n_log_n_exponent"], 1);
  EXPECT_TRUE(json["stages"]["partition"].contains("exponent"));
  EXPECT_NE(growth.text().find("76800 points"), std::string::npos);
}

}  // namespace
}  // namespace cleave::workbench
