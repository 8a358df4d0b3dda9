// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/graph/edge_heuristics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace cleave::segmentation {
namespace {

constexpr float degree_rad = std::numbers::pi_v<float> / 180;

// Two patches left and right of a crease along y; each is turned by half of `bend_deg` about it.
struct Crease {
  Surfel left, right;
  explicit Crease(float bend_deg, bool roof) {
    const float half = bend_deg / 2 * degree_rad;
    const float sign = roof ? 1.0F : -1.0F;
    left = {Eigen::Vector3f(-std::cos(half), 0, 0),
            Eigen::Vector3f(-sign * std::sin(half), 0, std::cos(half))};
    right = {Eigen::Vector3f(std::cos(half), 0, 0),
             Eigen::Vector3f(sign * std::sin(half), 0, std::cos(half))};
  }
};

TEST(Equation4_1, ARoofIsConvexAndAValleyAndAFlatFloorAreNot) {
  EXPECT_TRUE(is_convex(Crease(90, true).left, Crease(90, true).right));
  EXPECT_FALSE(is_convex(Crease(90, false).left, Crease(90, false).right));
  EXPECT_FALSE(is_convex(Crease(0, true).left, Crease(0, true).right));
}

TEST(Equation4_2, ARoofIsConvexAndAValleyAndAFlatFloorAreNot) {
  EXPECT_TRUE(is_convex_after_lai(Crease(90, true).left, Crease(90, true).right));
  EXPECT_FALSE(is_convex_after_lai(Crease(90, false).left, Crease(90, false).right));
  EXPECT_FALSE(is_convex_after_lai(Crease(0, true).left, Crease(0, true).right));
}

// "In the absolute majority of cases the two heuristics output the same result."
TEST(Equation4_2, AgreesWithEquation4_1OnCreasesOfEveryAngle) {
  for (int bend_deg = 2; bend_deg < 90; ++bend_deg) {
    for (const bool roof : {true, false}) {
      const Crease crease(static_cast<float>(bend_deg), roof);
      EXPECT_EQ(is_convex(crease.left, crease.right, Convexity::lai),
                is_convex(crease.left, crease.right, Convexity::karpathy))
          << bend_deg;
    }
  }
}

// A patch that stands a step above the other and leans towards it: j is above i's plane, so what
// counts for Lai is how its normal leans within that plane alone.
TEST(Equation4_2, LeavesOutTheStepBetweenThePatches) {
  const Surfel floor{Eigen::Vector3f::Zero(), Eigen::Vector3f::UnitZ()};
  const Surfel step{Eigen::Vector3f(1, 0, 2), Eigen::Vector3f(0.6F, 0, 0.8F)};

  EXPECT_TRUE(is_convex_after_lai(floor, step));             // d in the plane is (1, 0, 0)
  EXPECT_TRUE(is_convex(floor, step, Convexity::karpathy));  // 0.6 - 0.4 > 0
  const Surfel higher{Eigen::Vector3f(1, 0, 4), step.normal};
  EXPECT_TRUE(is_convex_after_lai(floor, higher));
  EXPECT_FALSE(is_convex(floor, higher, Convexity::karpathy));  // 0.6 - 0.8 < 0
}

TEST(Equation4_3, IsAGaussianIfAskedFor) {
  const GraphOptions options{
      .weight = WeightFunction::gaussian, .weight_sigma = 0.5F, .cannot_link_rad = 45 * degree_rad};
  const Crease valley(90, false);

  EXPECT_NEAR(edge_weight(valley.left, valley.right, options), std::exp(-4.0), 1e-6);
  EXPECT_LT(edge_weight(valley.left, valley.right, options), cannot_link_weight(options));
  EXPECT_GT(edge_weight(Crease(44, false).left, Crease(44, false).right, options),
            cannot_link_weight(options));
}

TEST(Equation4_3, WeighsConvexEdgesOneAndConcaveOnesByTheirAngle) {
  const GraphOptions options{.weight_sigma = 10};
  const Crease roof(90, true), valley(90, false), floor(0, false);

  EXPECT_FLOAT_EQ(edge_weight(roof.left, roof.right, options), 1);
  EXPECT_NEAR(edge_weight(valley.left, valley.right, options), 1.0 / 21, 1e-6);  // |dn|^2 = 2
  EXPECT_FLOAT_EQ(edge_weight(floor.left, floor.right, options), 1);
}

TEST(Equation4_4, MeasuresTheAngleToTheLineWhereThePlanesMeet) {
  Crease crease(90, false);
  EXPECT_NEAR(meeting_angle_rad(crease.left, crease.right), 90 * degree_rad, 1e-3);

  // The planes meet along y; centroids that differ along y touch in a point only.
  crease.right.position = crease.left.position + Eigen::Vector3f::UnitY();
  EXPECT_NEAR(meeting_angle_rad(crease.left, crease.right), 0, 1e-3);

  crease.right.position = crease.left.position + Eigen::Vector3f(1, 1, 0);
  EXPECT_NEAR(meeting_angle_rad(crease.left, crease.right), 45 * degree_rad, 1e-3);
}

TEST(Equation4_4, IsAQuarterTurnWherePlanesAreParallelOrCentroidsCoincide) {
  const Crease floor(0, false);
  Crease crease(90, false);
  crease.right.position = crease.left.position;

  EXPECT_NEAR(meeting_angle_rad(floor.left, floor.right), 90 * degree_rad, 1e-6);
  EXPECT_NEAR(meeting_angle_rad(crease.left, crease.right), 90 * degree_rad, 1e-6);
}

TEST(Equation4_5, IsASigmoidOfTheAngleBetweenNormals) {
  const GraphOptions options{.validity_max_rad = 57 * degree_rad,
                             .validity_offset_rad = 33 * degree_rad,
                             .validity_slope = 0.3F / degree_rad};

  EXPECT_NEAR(least_meeting_angle_rad(33 * degree_rad, options), 28.5 * degree_rad, 1e-5);
  EXPECT_NEAR(least_meeting_angle_rad(90 * degree_rad, options), 57 * degree_rad, 1e-5);
  // 57 / (1 + exp(-0.3 (23 - 33))) = 57 / (1 + e^3)
  EXPECT_NEAR(least_meeting_angle_rad(23 * degree_rad, options), 2.703 * degree_rad, 1e-4);
}

TEST(Equation4_6, RefusesPatchesThatTouchInAPoint) {
  Crease crease(90, false);
  EXPECT_TRUE(is_valid(crease.left, crease.right, {}));

  crease.right.position = crease.left.position + Eigen::Vector3f(0.2F, 1, 0);
  EXPECT_FALSE(is_valid(crease.left, crease.right, {}));
}

TEST(Equation4_7, ForbidsToLinkAcrossConcaveEdgesAboveTheThreshold) {
  const GraphOptions options{.cannot_link_rad = 45 * degree_rad};
  const auto cannot_link = [&](const Crease& crease) {
    return edge_weight(crease.left, crease.right, options) < cannot_link_weight(options);
  };

  EXPECT_FALSE(cannot_link(Crease(44, false)));
  EXPECT_TRUE(cannot_link(Crease(46, false)));
  EXPECT_FALSE(cannot_link(Crease(120, true)));
}

TEST(Step, IsTheDistanceBetweenParallelPlanes) {
  Crease floor(0, false);
  floor.right.position.z() = 0.25F;

  EXPECT_FLOAT_EQ(step_m(floor.left, floor.right), 0.25F);
}

TEST(Step, IsNothingForPatchesOfOneBallOrTwoFacesAsFarFromTheirCrease) {
  EXPECT_NEAR(step_m(Crease(40, true).left, Crease(40, true).right), 0, 1e-6);
  EXPECT_NEAR(step_m(Crease(90, false).left, Crease(90, false).right), 0, 1e-6);
}

TEST(Step, CountsFromALimitThatGrowsAsTheNoiseDoes) {
  const GraphOptions options{.max_step_m = 0.005F};
  const auto steps = [&options](float depth_m, float step) {
    const Surfel near{{0, 0, depth_m}, {0, 0, -1}};
    const Surfel far{{0.025F, 0, depth_m + step}, {0, 0, -1}};
    return is_step(near, far, options);
  };

  EXPECT_FALSE(steps(1, 0.004F));
  EXPECT_TRUE(steps(1, 0.006F));
  EXPECT_FALSE(steps(2, 0.018F));
  EXPECT_TRUE(steps(2, 0.022F));
}

TEST(Step, IsNoneWhereACreaseExplainsIt) {
  const GraphOptions options{.max_step_m = 0.001F};
  // A roof of 90 degrees at 1 m; one centroid is 10 mm from the ridge, the other 18 mm.
  const float root_half = std::sqrt(0.5F);
  const Surfel left{{-0.010F * root_half, 0, 1 + 0.010F * root_half}, {-root_half, 0, -root_half}};
  const Surfel right{{0.018F * root_half, 0, 1 + 0.018F * root_half}, {root_half, 0, -root_half}};

  EXPECT_NEAR(step_m(left, right), 0.004F * root_half * 2 / std::sqrt(2.0F), 1e-5);
  EXPECT_FALSE(is_step(left, right, options));
  EXPECT_FALSE(is_step(left, right, {.max_step_m = 0})) << "0 switches steps off";
}

TEST(SoftConstraint, GrowsFromNothingToACannotLinkEdge) {
  const GraphOptions options{.cannot_link_rad = 0.75F, .soft_cannot_link_rad = 0.25F};

  EXPECT_EQ(cannot_link_share(0.2F, options), 0);
  EXPECT_EQ(cannot_link_share(0.5F, options), 0.5F);
  EXPECT_EQ(cannot_link_share(0.7F, options), std::floor(0.9F * 64) / 64);
  EXPECT_EQ(cannot_link_share(0.5F, {.cannot_link_rad = 0.7F, .soft_cannot_link_rad = 0.7F}), 0);
}

}  // namespace
}  // namespace cleave::segmentation
