// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/view/camera/projective_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>

namespace cleave::segmentation {
namespace {

TEST(ProjectiveFit, FindsTheMapInSpiteOfStrays) {
  Eigen::Matrix3d map;
  map << 1.1, 0.02, 0.1, -0.03, 1.2, -0.2, 0.05, 0.1, 1;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-0.5, 0.5);
  ProjectiveFit<3> fit;
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d from(uniform(random), uniform(random), 1);
    const Eigen::Vector2d to = (map * from).hnormalized();
    fit.add(from, i % 10 == 0 ? Eigen::Vector2d(uniform(random), uniform(random)) : to);
  }

  const Eigen::Matrix3d found = fit.solve();

  EXPECT_LT((found / found(2, 2) - map).norm(), 1e-6);
}

TEST(ProjectiveFit, OfNothingIsNoMap) {
  ProjectiveFit<3> fit;

  EXPECT_TRUE(fit.solve().isZero(0));
}

}  // namespace
}  // namespace cleave::segmentation
