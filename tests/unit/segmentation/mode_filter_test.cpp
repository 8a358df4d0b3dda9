#include "segmentation/mode_filter.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace cleave::segmentation {
namespace {

std::vector<std::uint32_t> naive_filter(const SegmentImage& image, int radius, float gate_m) {
  auto result = image.segment;
  const int width = static_cast<int>(image.width);
  const int height = static_cast<int>(image.height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto at = [&](int column, int row) {
        return static_cast<std::size_t>(row) * image.width + static_cast<std::size_t>(column);
      };
      const std::uint32_t own = image.segment[at(x, y)];
      if (own == SegmentImage::no_segment) continue;
      std::map<std::uint32_t, int> count;
      for (int v = std::max(0, y - radius); v <= std::min(height - 1, y + radius); ++v) {
        for (int u = std::max(0, x - radius); u <= std::min(width - 1, x + radius); ++u) {
          const std::size_t i = at(u, v);
          if (image.segment[i] == SegmentImage::no_segment) continue;
          if (std::abs(image.depth_m[i] - image.depth_m[at(x, y)]) > gate_m) continue;
          ++count[image.segment[i]];
        }
      }
      std::uint32_t mode = own;
      for (const auto& [segment, pixels] : count) {
        if (pixels > count[mode]) mode = segment;
      }
      result[at(x, y)] = mode;
    }
  }
  return result;
}

SegmentImage random_image(unsigned seed) {
  std::mt19937 random(seed);
  SegmentImage image{.width = 61, .height = 47, .segment = {}, .depth_m = {}};
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = 0; x < image.width; ++x) {
      std::uint32_t segment = x / 17 + 10 * (y / 19);  // tiles with noise and holes
      if (random() % 12 == 0) segment = static_cast<std::uint32_t>(random() % 40);
      if (random() % 9 == 0) segment = SegmentImage::no_segment;
      image.segment.push_back(segment);
      image.depth_m.push_back(1 + 0.01F * static_cast<float>(random() % 4));
    }
  }
  return image;
}

TEST(ModeFilter, DoesWhatTheNaiveFilterDoes) {
  ModeFilter filter;
  for (unsigned seed = 0; seed < 5; ++seed) {
    for (const std::uint32_t radius : {1U, 4U}) {
      SegmentImage image = random_image(seed);
      const auto expected = naive_filter(image, static_cast<int>(radius), 0.02F);

      filter.filter(image, radius, 0.02F);

      EXPECT_EQ(image.segment, expected);
    }
  }
}

TEST(ModeFilter, TakesAWindowLargerThanTheImage) {
  SegmentImage image{.width = 3, .height = 2, .segment = {1, 1, 2, 1, 1, 1}, .depth_m = {}};
  image.depth_m.assign(6, 1);

  ModeFilter().filter(image, 20, 0.02F);

  EXPECT_EQ(image.segment, std::vector<std::uint32_t>(6, 1));
}

}  // namespace
}  // namespace cleave::segmentation
