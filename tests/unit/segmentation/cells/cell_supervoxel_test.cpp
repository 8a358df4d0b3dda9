// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <map>
#include <set>

#include "segmentation/cells/cell_adjacency.hpp"
#include "segmentation/cells/cell_clustering.hpp"
#include "segmentation/cells/cell_fragments.hpp"
#include "segmentation/cells/cell_image.hpp"
#include "segmentation/cells/cell_links.hpp"
#include "segmentation/cells/cell_normals.hpp"
#include "segmentation/cells/cell_supervoxels.hpp"
#include "tests/unit/segmentation/support/depth_scene.hpp"

namespace cleave::segmentation {
namespace {

constexpr std::uint32_t no_owner = CellClusterer::no_owner;

struct Cells {
  CellImage image;
  CellLinks links;
  PixelImage pixels;
  std::vector<std::size_t> occupied;
  std::vector<std::uint32_t> supervoxel;
  std::uint32_t supervoxels = 0;

  explicit Cells(unsigned seed) {
    const DepthScene scene(seed);
    EXPECT_TRUE(CellImager().gather(scene.view(), 0.006F, 0, image, pixels));
    CellNormalEstimator().estimate(image);
    link_cells(image, links);
    for (std::size_t i = 0; i < image.size(); ++i) {
      if (image.occupied(i)) occupied.push_back(i);
    }
    std::vector<std::uint32_t> owner;
    const std::uint32_t owners = CellClusterer().cluster(image, {}, owner);
    supervoxels = CellFragmentMender().mend(image, links, owner, owners, {}, supervoxel);
  }

  [[nodiscard]] std::size_t at(std::size_t cell, int dx, int dy) const {
    return cell + static_cast<std::size_t>(dy * static_cast<std::ptrdiff_t>(image.stride) + dx);
  }
  [[nodiscard]] Eigen::Vector3d ray(std::size_t i) const { return {image.u[i], image.v[i], 1}; }
  [[nodiscard]] std::set<std::size_t> linked_to(std::size_t i) const {
    std::set<std::size_t> others;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto step = static_cast<std::size_t>(image.steps()[k]);
      if ((links[i] >> k & 1) != 0) others.insert(i + step);
      if ((links[i - step] >> k & 1) != 0) others.insert(i - step);
    }
    return others;
  }
};

struct Plane {
  Eigen::Vector3d coefficients;
  double variance = 1;
};

// The weighted least squares of CellNormalEstimator, by QR in double precision.
Plane regress(const Cells& cells, std::size_t i) {
  std::vector<std::pair<std::size_t, double>> near;
  for (int dy = -2; dy <= 2; ++dy) {
    for (int dx = -2; dx <= 2; ++dx) {
      const std::size_t j = cells.at(i, dx, dy);
      const double gate = 0.012 * std::max(std::abs(dx), std::abs(dy));
      const double q = cells.image.inverse_depth[i];
      const bool counts = j == i || std::abs(cells.image.inverse_depth[j] - q) < gate * q;
      if (counts) near.emplace_back(j, (3 - std::abs(dx)) * (3 - std::abs(dy)));
    }
  }
  const auto n = static_cast<Eigen::Index>(near.size());
  Eigen::MatrixXd rows(n, 3);
  Eigen::VectorXd values(n);
  double weights = 0;
  for (Eigen::Index k = 0; k < n; ++k) {
    const auto& [j, weight] = near[static_cast<std::size_t>(k)];
    rows.row(k) = std::sqrt(weight) * cells.ray(j).transpose();
    values[k] = std::sqrt(weight) * static_cast<double>(cells.image.inverse_depth[j]);
    weights += weight;
  }
  const Eigen::Vector3d plane = rows.colPivHouseholderQr().solve(values);
  return {plane, (rows * plane - values).squaredNorm() / weights};
}

TEST(CellNormalEstimator, TakesTheBestPlaneOfTheNineAround) {
  const Cells cells(4);
  std::size_t checked = 0;
  for (std::size_t k = 0; k < cells.occupied.size(); k += 3) {
    const std::size_t i = cells.occupied[k];
    double best = 1e9;
    double second = 1e9;
    Eigen::Vector3d chosen;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const std::size_t j = cells.at(i, dx, dy);
        if (!cells.image.occupied(j)) continue;
        const Plane plane = regress(cells, j);
        const double miss = plane.coefficients.dot(cells.ray(i)) -
                            static_cast<double>(cells.image.inverse_depth[i]);
        const double cost =
            j == i ? plane.variance + 4e-6 : 1.5 * (plane.variance + miss * miss + 4e-6);
        second = std::min(second, std::max(cost, best));
        if (cost >= best) continue;
        best = cost;
        chosen = plane.coefficients;
      }
    }
    if (second < best * 1.02) continue;  // too close to call in single precision
    const Eigen::Vector3d normal = -chosen.normalized();
    const Eigen::Vector3d found(cells.image.normal_x[i], cells.image.normal_y[i],
                                cells.image.normal_z[i]);
    EXPECT_GT(normal.dot(found), 0.9999);
    ++checked;
  }
  EXPECT_GT(checked, cells.occupied.size() / 5);
}

TEST(CellLinks, AreNeverWithEmptyCells) {
  const Cells cells(5);
  for (std::size_t i = 0; i < cells.image.size(); ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      if ((cells.links[i] >> k & 1) == 0) continue;
      EXPECT_TRUE(cells.image.occupied(i));
      EXPECT_TRUE(cells.image.occupied(i + static_cast<std::size_t>(cells.image.steps()[k])));
    }
  }
}

TEST(CellLinks, FollowDepthAndPlanes) {
  const Cells cells(6);
  const CellImage& image = cells.image;
  const auto position = [&](std::size_t i) {
    return Eigen::Vector3d(image.x[i], image.y[i], image.z[i]);
  };
  const auto normal = [&](std::size_t i) {
    return Eigen::Vector3d(image.normal_x[i], image.normal_y[i], image.normal_z[i]);
  };
  for (const std::size_t i : cells.occupied) {
    const std::size_t j = cells.at(i, 1, 1);
    if (!image.occupied(j)) continue;
    const double q = (double{image.inverse_depth[i]} + double{image.inverse_depth[j]}) / 2;
    const double dq = std::abs(double{image.inverse_depth[i]} - double{image.inverse_depth[j]}) / q;
    const Eigen::Vector3d d = position(j) - position(i);
    const double off =
        std::max(std::abs(d.dot(normal(i))), std::abs(d.dot(normal(j)))) / double{image.z[i]};
    if (std::abs(dq - 0.01) < 1e-5 || std::abs(dq - 0.04) < 1e-5 || std::abs(off - 0.005) < 1e-5) {
      continue;  // too close to call in single precision
    }
    EXPECT_EQ(cells.linked_to(i).contains(j), dq < 0.01 || (dq < 0.04 && off < 0.005));
  }
}

TEST(CellClusterer, SweepsThreeTimesUnlessItIsToldHowOften) {
  const Cells cells(6);
  const auto owners_after = [&](std::uint32_t sweeps) {
    std::vector<std::uint32_t> owner;
    (void)CellClusterer().cluster(cells.image, {.sweeps = sweeps}, owner);
    return owner;
  };

  EXPECT_EQ(owners_after(0), owners_after(3));
  EXPECT_NE(owners_after(2), owners_after(3));
  EXPECT_NE(owners_after(4), owners_after(3));
}

TEST(CellFragmentMender, GivesEveryOccupiedCellAConnectedSupervoxel) {
  const Cells cells(7);
  std::set<std::size_t> reached;
  std::set<std::uint32_t> seen;
  for (const std::size_t i : cells.occupied) {
    const std::uint32_t supervoxel = cells.supervoxel[i];
    ASSERT_LT(supervoxel, cells.supervoxels);
    if (!seen.insert(supervoxel).second) continue;
    std::vector<std::size_t> stack = {i};
    reached.insert(i);
    while (!stack.empty()) {
      const std::size_t from = stack.back();
      stack.pop_back();
      for (const std::size_t j : cells.linked_to(from)) {
        if (cells.supervoxel[j] == supervoxel && reached.insert(j).second) stack.push_back(j);
      }
    }
  }
  EXPECT_EQ(reached.size(), cells.occupied.size());
  EXPECT_EQ(seen.size(), cells.supervoxels);
}

class CellSupervoxelFit : public testing::TestWithParam<bool> {};

TEST_P(CellSupervoxelFit, RegressesOnAllCellsOfASupervoxelByTheirPointsOrOnceEach) {
  const bool from_points = GetParam();
  const Cells cells(8);
  Supervoxels supervoxels;

  CellSupervoxelFitter().fit(cells.image, cells.supervoxel, cells.supervoxels, from_points,
                             supervoxels);

  std::map<std::uint32_t, std::vector<std::size_t>> members;
  for (const std::size_t i : cells.occupied) members[cells.supervoxel[i]].push_back(i);
  for (const auto& [s, of] : members) {
    if (of.size() < 12) continue;  // narrow ones are badly conditioned
    const auto n = static_cast<Eigen::Index>(of.size());
    Eigen::MatrixXd rows(n, 3);
    Eigen::VectorXd values(n);
    double points = 0;
    for (Eigen::Index k = 0; k < n; ++k) {
      const std::size_t i = of[static_cast<std::size_t>(k)];
      const double weight = from_points ? std::sqrt(double{cells.image.points[i]}) : 1;
      rows.row(k) = weight * cells.ray(i).transpose();
      values[k] = weight * double{cells.image.inverse_depth[i]};
      points += double{cells.image.points[i]};
    }
    const Eigen::Vector3d normal = -rows.colPivHouseholderQr().solve(values).normalized();
    EXPECT_GT(normal.dot(supervoxels.surfel[s].normal.cast<double>()), 0.9999);
    EXPECT_EQ(supervoxels.point_count[s], points);
  }
}

INSTANTIATE_TEST_SUITE_P(FromPointsOrCells, CellSupervoxelFit, testing::Bool());

TEST(CellAdjacencyFinder, FindsWhatBruteForceFinds) {
  const Cells cells(9);
  std::vector<AdjacentPair> pairs;

  CellAdjacencyFinder().find(cells.image, cells.links, cells.supervoxel, cells.supervoxels, pairs);

  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> expected;
  for (const std::size_t i : cells.occupied) {
    for (const std::size_t j : cells.linked_to(i)) {
      if (cells.supervoxel[i] < cells.supervoxel[j]) {
        ++expected[{cells.supervoxel[i], cells.supervoxel[j]}];
      }
    }
  }
  ASSERT_EQ(pairs.size(), expected.size());
  auto next = expected.begin();
  for (const AdjacentPair& pair : pairs) {
    EXPECT_EQ(std::make_pair(pair.first, pair.second), next->first);
    EXPECT_EQ(pair.touching_voxels, next->second);
    ++next;
  }
}

}  // namespace
}  // namespace cleave::segmentation
