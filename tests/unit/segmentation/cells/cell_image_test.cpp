// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/cells/cell_image.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "segmentation/points/point_set.hpp"
#include "tests/unit/segmentation/support/depth_scene.hpp"

namespace cleave::segmentation {
namespace {

constexpr float size = 0.006F;  // three pixels of the scene

TEST(CellImager, TakesTheMeanOfTheFrontLayer) {
  const DepthScene scene(1);
  CellImage cells;
  PixelImage pixels;

  ASSERT_TRUE(CellImager().gather(scene.view(), size, 0.5F, cells, pixels));

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

TEST(CellImager, KeepsThePointOfEveryPixel) {
  const DepthScene scene(2);
  CellImage cells;
  PixelImage pixels;

  for (const float offset : {0.0F, 0.5F}) {
    ASSERT_TRUE(CellImager().gather(scene.view(), size, offset, cells, pixels));

    for (std::uint32_t y = 0; y < scene.height; ++y) {
      for (std::uint32_t x = 0; x < scene.width; ++x) {
        const float* p = scene.view().point(std::size_t{y} * scene.width + x);
        const std::size_t i = pixels.layout.row_begin(y) + x;
        EXPECT_EQ(pixels.z[i], std::isfinite(p[2]) ? p[2] : PixelImage::no_depth);
        EXPECT_EQ(pixels.x[i], std::isfinite(p[2]) ? p[0] : 0);
        EXPECT_EQ(pixels.y[i], std::isfinite(p[2]) ? p[1] : 0);
      }
    }
  }
}

TEST(CellImager, ReadsPointsAnyNumberOfFloatsApart) {
  const DepthScene scene(2);
  CellImage cells;
  PixelImage packed;
  ASSERT_TRUE(CellImager().gather(scene.view(), size, 0, cells, packed));
  for (const std::size_t stride : {4U, 7U}) {
    std::vector<float> xyz(scene.view().size() * stride, -5);
    for (std::size_t i = 0; i < scene.view().size(); ++i) {
      std::copy_n(scene.view().point(i), 3, xyz.data() + i * stride);
    }
    PixelImage apart;

    ASSERT_TRUE(CellImager().gather({xyz.data(), stride, scene.width, scene.height}, size, 0, cells,
                                    apart));

    EXPECT_EQ(apart.x, packed.x);
    EXPECT_EQ(apart.y, packed.y);
    EXPECT_EQ(apart.z, packed.z);
  }
}

TEST(CellImager, TakesAnImageWithAStrayPoint) {
  DepthScene scene(4);
  std::fill_n(scene.xyz.begin() + 3 * 5000, 3, 1e30F);
  CellImage cells;
  PixelImage pixels;

  ASSERT_TRUE(CellImager().gather(scene.view(), size, 0, cells, pixels));

  const std::size_t stray = pixels.layout.row_begin(5000 / scene.width) + 5000 % scene.width;
  EXPECT_EQ(pixels.z[stray], max_coordinate_m);
}

TEST(CellImager, RefusesWhatIsNotAnImageFromTheOrigin) {
  CellImage cells;
  PixelImage pixels;
  const auto accepts = [&](const DepthScene& scene) {
    return CellImager().gather(scene.view(), size, 0, cells, pixels);
  };

  DepthScene unorganised(3);
  unorganised.width *= unorganised.height;
  unorganised.height = 1;
  EXPECT_FALSE(accepts(unorganised));

  DepthScene behind(3);
  for (std::size_t i = 5000; i < 5100; ++i) {
    behind.xyz[3 * i] = behind.xyz[3 * i + 1] = 0;
    behind.xyz[3 * i + 2] = -1;
  }
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
