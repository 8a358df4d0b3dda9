// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/describe/run_sums.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>
#include <vector>

namespace cleave::segmentation {
namespace {

struct Points {
  explicit Points(std::size_t count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> coordinate(-0.5F, 2);
    for (std::size_t i = 0; i < count; ++i) {
      x.push_back(coordinate(random));
      y.push_back(coordinate(random));
      z.push_back(coordinate(random));
    }
  }
  // Runs of every length from 1 on, until the points are used up.
  template <typename Work>
  void for_runs(Work&& work) const {
    for (std::size_t begin = 0, length = 1; begin < x.size(); begin += length++) {
      const std::size_t count = std::min(length, x.size() - begin);
      work(PointRange{x.data() + begin, y.data() + begin, z.data() + begin, count});
    }
  }
  std::vector<float> x, y, z;
};

TEST(RunMoments, AreThoseOfPointsAddedOneByOne) {
  const Points points(333);
  Moments expected;
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    expected.add_point(points.x[i], points.y[i], points.z[i]);
  }
  RunMoments sums;

  points.for_runs([&](const PointRange& run) { sums.add(run); });

  const Moments total = sums.total();
  EXPECT_EQ(total.n, 333);
  EXPECT_LT((total.mean() - expected.mean()).norm(), 1e-12);
  EXPECT_LT((total.covariance() - expected.covariance()).norm(), 1e-12);
}

TEST(RunExtent, ReachesEveryPointAndCountsThoseNearThePlane) {
  const Points points(333);
  const Eigen::Matrix3f axes =
      Eigen::AngleAxisf(0.6F, Eigen::Vector3f(1, 2, 3).normalized()).toRotationMatrix();
  const Eigen::Vector3f normal = Eigen::Vector3f(1, -1, 0.5F).normalized();
  const Eigen::Vector3f on_plane(0.5F, 0.5F, 1);
  Eigen::Vector3f low = Eigen::Vector3f::Constant(1e9F);
  Eigen::Vector3f high = -low;
  std::uint32_t near = 0;
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    const Eigen::Vector3f p(points.x[i], points.y[i], points.z[i]);
    low = low.cwiseMin(axes.transpose() * p);
    high = high.cwiseMax(axes.transpose() * p);
    near += std::abs(normal.dot(p - on_plane)) <= 0.2F ? 1 : 0;
  }
  RunExtent extent;
  extent.aim(axes, normal, on_plane, 0.2F);

  points.for_runs([&](const PointRange& run) { extent.add(run); });

  EXPECT_LT((extent.low() - low).norm(), 1e-6F);
  EXPECT_LT((extent.high() - high).norm(), 1e-6F);
  EXPECT_EQ(extent.points_on_plane(), near);
}

}  // namespace
}  // namespace cleave::segmentation
