// SPDX-License-Identifier: BSD-3-Clause
#include "recording/units/nearest_spacing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace cleave::recording {
namespace {

std::vector<PlanePoint> grid(int edge, float step) {
  std::vector<PlanePoint> points;
  for (int i = 0; i < edge * edge; ++i) {
    points.push_back({step * static_cast<float>(i % edge), step * static_cast<float>(i / edge)});
  }
  return points;
}

TEST(NearestSpacing, OfAGridIsItsStepEverywhere) {
  const NearestSpacing spacing = nearest_spacing(grid(50, 0.25F));

  EXPECT_EQ(spacing.median, 0.25);
  EXPECT_EQ(spacing.spread, 1);
}

TEST(NearestSpacing, OfScatteredPointsIsThatOfEveryPairComparedWithEveryOther) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(0, 1);
  std::vector<PlanePoint> points;
  for (int i = 0; i < 900; ++i) points.push_back({uniform(random), uniform(random)});
  std::vector<double> nearest;
  for (const PlanePoint& p : points) {
    double least = std::numeric_limits<double>::infinity();
    for (const PlanePoint& q : points) {
      const double distance = std::hypot(double{q.x} - double{p.x}, double{q.y} - double{p.y});
      if (distance > 0) least = std::min(least, distance);
    }
    nearest.push_back(least);
  }
  std::ranges::sort(nearest);

  const NearestSpacing spacing = nearest_spacing(points);

  EXPECT_NEAR(spacing.median, nearest[450], 0.05 * nearest[450]);
  EXPECT_GT(spacing.spread, 3);
}

TEST(NearestSpacing, IsNotMisledByAPointFarAway) {
  std::vector<PlanePoint> points = grid(50, 0.25F);
  points.push_back({1e6F, -1e6F});

  EXPECT_EQ(nearest_spacing(points).median, 0.25);
}

TEST(NearestSpacing, DoesNotComparePointsOfACrowdWithEachOther) {
  std::vector<PlanePoint> points = grid(50, 0.25F);
  points.insert(points.end(), 300000, {7, 7});  // a sensor that has a depth for "nothing here"

  EXPECT_EQ(nearest_spacing(points).median, 0);
}

TEST(NearestSpacing, OfNoneOneAndEqualPointsIsNone) {
  EXPECT_EQ(nearest_spacing({}).median, 0);
  EXPECT_EQ(nearest_spacing({{1, 1}}).median, 0);
  EXPECT_EQ(nearest_spacing(std::vector<PlanePoint>(500, {1, 1})).median, 0);
}

}  // namespace
}  // namespace cleave::recording
