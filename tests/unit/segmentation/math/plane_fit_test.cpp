// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/math/plane_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>

namespace cleave::segmentation {
namespace {

TEST(PlaneFit, FindsTheSmallestEigenvectorOfRandomCovariances) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 1000; ++i) {
    Moments moments;
    const double thickness = std::pow(10.0, -(i % 6));
    for (int k = 0; k < 20; ++k) {
      moments.add_point(normal(random), 2 * normal(random) + 1, thickness * normal(random) + 3);
    }
    const Eigen::Matrix3d covariance = moments.covariance();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> oracle(covariance);

    const auto found = smallest_eigenvector(covariance);

    ASSERT_TRUE(found);
    EXPECT_NEAR(std::abs(found->dot(oracle.eigenvectors().col(0))), 1, 1e-6);
  }
}

TEST(PlaneFit, HasNoEigenvectorWherePointsLieOnALineOrInOneSpot) {
  Moments line, spot;
  for (int i = 0; i < 5; ++i) {
    line.add_point(i, 2 * i, 3 * i);
    spot.add_point(1, 1, 1);
  }

  EXPECT_FALSE(smallest_eigenvector(line.covariance()));
  EXPECT_FALSE(smallest_eigenvector(spot.covariance()));
}

TEST(PlaneFit, PointsTheNormalTowardsTheSensor) {
  Moments wall;
  for (int i = 0; i < 9; ++i) wall.add_point(i % 3, static_cast<double>(i) / 3, 2);

  EXPECT_TRUE(fit_normal(wall).isApprox(-Eigen::Vector3f::UnitZ(), 1e-5F));
}

TEST(PlaneFit, FallsBackOnTheDirectionToTheSensor) {
  Moments lone;
  lone.add_point(0, 3, 4);
  Moments at_sensor;
  at_sensor.add_point(0, 0, 0);

  EXPECT_TRUE(fit_normal(lone).isApprox(Eigen::Vector3f(0, -0.6F, -0.8F)));
  EXPECT_TRUE(fit_normal(at_sensor).isApprox(-Eigen::Vector3f::UnitZ()));
}

TEST(Equation2_2, IsTheShareOfTheSmallestEigenvalue) {
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 100; ++i) {
    Moments moments;
    for (int k = 0; k < 20; ++k) {
      moments.add_point(normal(random), 2 * normal(random) + 1, 0.3 * normal(random) + 3);
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> oracle(moments.covariance());
    const double expected = oracle.eigenvalues()[0] / oracle.eigenvalues().sum();

    EXPECT_NEAR(surface_variation(moments), expected, 1e-6);
  }
}

TEST(Equation2_2, IsAThirdForACubeAndZeroForAPlaneALineAndASpot) {
  Moments cube, plane, line, spot;
  for (int i = 0; i < 8; ++i) {
    cube.add_point(i % 2, i / 2 % 2, 1 + i / 4);  // NOLINT(bugprone-integer-division)
    plane.add_point(i % 3, i % 2, 2);
    line.add_point(i, 2 * i, 3 * i);
    spot.add_point(1, 1, 1);
  }

  EXPECT_NEAR(surface_variation(cube), 1.0 / 3, 1e-6);
  EXPECT_NEAR(surface_variation(plane), 0, 1e-6);
  EXPECT_NEAR(surface_variation(line), 0, 1e-6);
  EXPECT_EQ(surface_variation(spot), 0);
  EXPECT_EQ(surface_variation(Moments{}), 0);
}

}  // namespace
}  // namespace cleave::segmentation
