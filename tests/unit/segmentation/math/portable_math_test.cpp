// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/math/portable_math.hpp"

#include <gtest/gtest.h>

namespace cleave::segmentation {
namespace {

TEST(PortableMath, AgreesWithTheLibrary) {
  constexpr int steps = 20000;
  for (int i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    const double cosine = 2 * share - 1;
    EXPECT_NEAR(portable::acos(cosine), std::acos(cosine), 3e-8);
    const double quarter_rad = cosine * std::numbers::pi / 2;
    EXPECT_NEAR(portable::sin(quarter_rad), std::sin(quarter_rad), 1e-13);
    const double half_rad = share * std::numbers::pi;
    EXPECT_NEAR(portable::cos(half_rad), std::cos(half_rad), 1e-13);
    const double exponent = 60 * cosine;
    EXPECT_NEAR(portable::exp(exponent) / std::exp(exponent), 1, 1e-13);
    const auto depth_m = static_cast<float>(std::exp(exponent));
    const double exact = std::log(double{depth_m});
    EXPECT_NEAR(portable::log(depth_m), exact, 3e-7 * std::max(1.0, std::abs(exact)));
  }
}

TEST(PortableMath, TurnsByStepsOfFiveDegreesAsTheLibraryDoes) {
  for (int degrees = 0; degrees < 90; degrees += 5) {
    const double angle_rad = std::numbers::pi / 180 * degrees;
    EXPECT_FLOAT_EQ(static_cast<float>(portable::sin(angle_rad)),
                    static_cast<float>(std::sin(angle_rad)));
    EXPECT_FLOAT_EQ(static_cast<float>(portable::cos(angle_rad)),
                    static_cast<float>(std::cos(angle_rad)));
  }
  static_assert(static_cast<float>(portable::cos(0)) == 1, "known to the compiler, and no turn");
}

TEST(PortableMath, HasNoEndInItsExponents) {
  EXPECT_GT(portable::exp(1e9), 1e300);
  EXPECT_LT(portable::exp(-1e9), 1e-300);
  EXPECT_EQ(portable::exp(0), 1);
  EXPECT_EQ(portable::log(1), 0);
}

}  // namespace
}  // namespace cleave::segmentation
