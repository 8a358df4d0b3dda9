// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/points/mode_filter.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace cleave::segmentation {
namespace {

using Segments = std::vector<std::uint32_t>;

Segments inside(const PixelImage& image) {
  Segments segments;
  for (std::uint32_t y = 0; y < image.layout.height; ++y) {
    const auto row = image.segment.begin() + static_cast<std::ptrdiff_t>(image.layout.row_begin(y));
    segments.insert(segments.end(), row, row + image.layout.width);
  }
  return segments;
}

Segments naive_filter(const PixelImage& image, std::uint32_t radius, float gate_m) {
  Segments result;
  const auto [width, height, shift, stride] = image.layout;
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      const std::size_t middle = image.layout.row_begin(y) + x;
      result.push_back(image.segment[middle]);
      if (result.back() == PixelImage::no_segment) continue;
      std::map<std::uint32_t, int> count;
      for (std::uint32_t v = y - std::min(y, radius); v < std::min(height, y + radius + 1); ++v) {
        for (std::uint32_t u = x - std::min(x, radius); u < std::min(width, x + radius + 1); ++u) {
          const std::size_t i = image.layout.row_begin(v) + u;
          if (image.segment[i] == PixelImage::no_segment) continue;
          if (std::abs(image.z[i] - image.z[middle]) > gate_m) continue;
          ++count[image.segment[i]];
        }
      }
      for (const auto& [segment, pixels] : count) {
        if (pixels > count[result.back()]) result.back() = segment;
      }
    }
  }
  return result;
}

PixelImage empty_image(std::uint32_t width, std::uint32_t height) {
  PixelImage image;
  image.lay_out(
      {.width = width, .height = height, .shift_x = 0, .stride = width + 2 * ImageLayout::border});
  return image;
}

// Tiles with noise and holes.
PixelImage random_image(unsigned seed) {
  std::mt19937 random(seed);
  PixelImage image = empty_image(61, 47);
  for (std::uint32_t y = 0; y < image.layout.height; ++y) {
    for (std::uint32_t x = 0; x < image.layout.width; ++x) {
      if (random() % 9 == 0) continue;
      const std::size_t i = image.layout.row_begin(y) + x;
      image.segment[i] = x / 17 + 10 * (y / 19);
      if (random() % 12 == 0) image.segment[i] = static_cast<std::uint32_t>(random() % 40);
      image.z[i] = 1 + 0.01F * static_cast<float>(random() % 4);
    }
  }
  return image;
}

void filter(PixelImage& image, std::uint32_t radius) {
  MixedWindowFinder finder;
  std::vector<PixelSpan> mixed;
  finder.clear_marks(image.layout.size());
  finder.find({.edge = 1,
               .columns = image.layout.width,
               .rows = image.layout.height,
               .stride = image.layout.stride,
               .first = image.layout.row_begin(0)},
              image.segment, radius, image.layout, mixed);
  ModeFilter().filter(image, mixed, radius, 0.02F);
}

TEST(ModeFilter, DoesWhatTheNaiveFilterDoes) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    for (const std::uint32_t radius : {1U, 4U, 20U}) {
      PixelImage image = random_image(seed);
      const auto expected = naive_filter(image, radius, 0.02F);

      filter(image, radius);

      EXPECT_EQ(inside(image), expected);
    }
  }
}

// Of few segments and many holes, so that most windows hold one segment.
TEST(ModeFilter, MissesNoWindowWithTwoSegments) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    PixelImage image = empty_image(50, 40);
    for (int k = 0; k < 60; ++k) {
      const std::size_t i =
          image.layout.row_begin(static_cast<std::uint32_t>(random() % 40)) + random() % 50;
      image.segment[i] = static_cast<std::uint32_t>(random() % 2);
      image.z[i] = 1;
    }
    const auto expected = naive_filter(image, 4, 0.02F);

    filter(image, 4);

    EXPECT_EQ(inside(image), expected);
  }
}

// Tiles of 3 x 3 pixels, as cells are, of which a few hold several segments.
TEST(ModeFilter, MissesNoWindowWithTwoSegmentsAmongTiles) {
  constexpr std::uint32_t edge = 3;
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    TileGrid grid{.edge = edge,
                  .shift_x = seed % 3,
                  .shift_y = seed / 3 % 3,
                  .columns = 15,
                  .rows = 12,
                  .stride = 17,
                  .first = 20};
    const auto width = grid.columns * edge - grid.shift_x - 1;
    const auto height = grid.rows * edge - grid.shift_y - 2;
    PixelImage image = empty_image(width, height);
    Segments tiles(grid.stride * (grid.rows + 3), PixelImage::no_segment);
    MixedWindowFinder finder;
    auto& marks = finder.clear_marks(tiles.size());
    for (std::uint32_t row = 0; row < grid.rows; ++row) {
      for (std::uint32_t column = 0; column < grid.columns; ++column) {
        if (random() % 4 == 0) continue;
        const std::size_t tile = grid.first + row * grid.stride + column;
        tiles[tile] = column < 7 ? 1 : 2;
        const bool mixed = random() % 40 == 0;
        marks[tile] = mixed ? 1 : 0;
        for (std::uint32_t k = 0; k < edge * edge; ++k) {
          const std::uint32_t x = column * edge + k % edge - grid.shift_x;
          const std::uint32_t y = row * edge + k / edge - grid.shift_y;
          if (x >= width || y >= height) continue;  // below 0 wraps around
          const std::size_t i = image.layout.row_begin(y) + x;
          image.segment[i] = mixed && random() % 2 == 0 ? 3 : tiles[tile];
          image.z[i] = 1;
        }
      }
    }
    for (const std::uint32_t radius : {1U, 4U, 7U}) {
      PixelImage filtered = image;
      std::vector<PixelSpan> spans;
      MixedWindowFinder again;
      again.clear_marks(tiles.size()) = marks;
      again.find(grid, tiles, radius, image.layout, spans);

      ModeFilter().filter(filtered, spans, radius, 0.02F);

      EXPECT_EQ(inside(filtered), naive_filter(image, radius, 0.02F)) << seed;
    }
  }
}

TEST(ModeFilter, TakesAWindowLargerThanTheImage) {
  PixelImage image = empty_image(3, 2);
  for (std::uint32_t y = 0; y < 2; ++y) {
    for (std::uint32_t x = 0; x < 3; ++x) {
      image.segment[image.layout.row_begin(y) + x] = x == 2 && y == 0 ? 2 : 1;
      image.z[image.layout.row_begin(y) + x] = 1;
    }
  }

  filter(image, 20);

  EXPECT_EQ(inside(image), Segments(6, 1));
}

}  // namespace
}  // namespace cleave::segmentation
