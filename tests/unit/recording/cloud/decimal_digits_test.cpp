// SPDX-License-Identifier: BSD-3-Clause
#include "recording/cloud/decimal_digits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>

namespace cleave::recording {
namespace {

// The slow way.
float through_text(float x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.7g", static_cast<double>(x));
  return std::strtof(text, nullptr);
}

TEST(DecimalDigits, RoundsAsTextWith7DigitsDoes) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-5.9, 5.6);
  for (int i = 0; i < 100'000; ++i) {
    const auto size = static_cast<float>(std::pow(10, exponent(random)));
    const float x = random() % 2 == 0 ? size : -size;
    ASSERT_EQ(round_to_7_digits(static_cast<double>(x)), through_text(x)) << x;
  }
}

TEST(DecimalDigits, KeepsPowersOfTenAndWhatIsNoNumber) {
  for (const float x : {1e-5F, 1e-3F, 0.1F, 1.0F, 10.0F, 1e5F, 0.0F}) {
    EXPECT_EQ(round_to_7_digits(static_cast<double>(x)), x);
  }
  EXPECT_TRUE(std::isnan(round_to_7_digits(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_TRUE(std::isinf(round_to_7_digits(std::numeric_limits<double>::infinity())));
}

}  // namespace
}  // namespace cleave::recording
