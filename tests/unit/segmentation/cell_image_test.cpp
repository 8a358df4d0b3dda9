#include "segmentation/cell_image.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "depth_scene.hpp"

namespace cleave::segmentation {
namespace {

constexpr float size = 0.006F;  // three pixels of the scene

TEST(CellImager, TakesTheMeanOfTheFrontLayer) {
  const DepthScene scene(1);
  CellImage cells;
  DepthImage depth_m;

  ASSERT_TRUE(CellImager().gather(scene.view(), size, 0.5F, cells, depth_m));

  ASSERT_EQ(cells.edge, 3U);
  for (std::uint32_t row = 0; row < cells.rows; ++row) {
    for (std::uint32_t column = 0; column < cells.columns; ++column) {
      std::vector<const float*> points;
      float nearest = std::numeric_limits<float>::max();
      for (std::uint32_t k = 0; k < 9; ++k) {
        const std::uint32_t x = column * 3 + k % 3 - cells.shift_x;
        const std::uint32_t y = row * 3 + k / 3 - cells.shift_y;
        if (x >= scene.width || y >= scene.height) continue;  // below 0 wraps around
        const float* p = scene.view().point(std::size_t{y} * scene.width + x);
        if (!std::isfinite(p[2])) continue;
        points.push_back(p);
        nearest = std::min(nearest, p[2]);
      }
      std::erase_if(points, [&](const float* p) { return p[2] > nearest * 1.015F; });
      double sum_x = 0;
      double sum_z = 0;
      for (const float* p : points) {
        sum_x += p[0];
        sum_z += p[2];
      }
      const std::size_t cell = cells.row_begin(row) + column;
      ASSERT_EQ(cells.points[cell], static_cast<float>(points.size()));
      if (points.empty()) continue;
      const auto n = static_cast<double>(points.size());
      EXPECT_NEAR(cells.x[cell], sum_x / n, 1e-5);
      EXPECT_NEAR(cells.z[cell], sum_z / n, 1e-5);
      EXPECT_NEAR(cells.inverse_depth[cell], n / sum_z, 1e-5);
    }
  }
}

TEST(CellImager, KeepsTheDepthOfEveryPixel) {
  const DepthScene scene(2);
  CellImage cells;
  DepthImage depth_m;

  ASSERT_TRUE(CellImager().gather(scene.view(), size, 0, cells, depth_m));

  for (std::size_t i = 0; i < depth_m.size(); ++i) {
    const float z = scene.view().point(i)[2];
    EXPECT_EQ(depth_m[i], std::isfinite(z) ? z : 0);
  }
}

TEST(CellImager, RefusesWhatIsNotAnImageFromTheOrigin) {
  CellImage cells;
  DepthImage depth_m;
  const auto accepts = [&](const DepthScene& scene) {
    return CellImager().gather(scene.view(), size, 0, cells, depth_m);
  };

  DepthScene unorganised(3);
  unorganised.width *= unorganised.height;
  unorganised.height = 1;
  EXPECT_FALSE(accepts(unorganised));

  DepthScene behind(3);
  behind.xyz[3 * 5000 + 2] = -1;
  behind.xyz[3 * 5000] = behind.xyz[3 * 5000 + 1] = 0;
  EXPECT_FALSE(accepts(behind));

  DepthScene mirrored(3);
  for (std::size_t i = 0; i < mirrored.xyz.size(); i += 3) mirrored.xyz[i] = -mirrored.xyz[i];
  EXPECT_FALSE(accepts(mirrored));

  DepthScene shuffled(3);
  for (std::size_t row = 0; row < 10; ++row) {
    std::swap_ranges(shuffled.xyz.begin() + static_cast<std::ptrdiff_t>(row * 480),
                     shuffled.xyz.begin() + static_cast<std::ptrdiff_t>(row * 480 + 480),
                     shuffled.xyz.begin() + static_cast<std::ptrdiff_t>((row + 60) * 480));
  }
  EXPECT_FALSE(accepts(shuffled));

  DepthScene empty(3);
  std::fill(empty.xyz.begin(), empty.xyz.end(), std::numeric_limits<float>::quiet_NaN());
  EXPECT_FALSE(accepts(empty));
  EXPECT_TRUE(accepts(DepthScene(3)));
}

}  // namespace
}  // namespace cleave::segmentation
