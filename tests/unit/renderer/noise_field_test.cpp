// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/renderer/noise_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace cleave::render {
namespace {

double correlation(const std::vector<float>& field, std::size_t width, std::size_t lag) {
  double sum = 0;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const std::size_t row = i / width * width;
    sum += double{field[i]} * field[row + (i - row + lag) % width];
  }
  return sum / static_cast<double>(field.size());
}

// Three box filters, summed pixel by pixel.
std::vector<float> slow_field(std::uint64_t seed, std::size_t width, std::size_t height,
                              std::size_t radius) {
  Random random(seed);
  std::vector<double> field(width * height);
  for (double& value : field) value = random.normal();
  for (int pass = 0; pass < 3; ++pass) {
    std::vector<double> sums(field.size());
    for (std::size_t y = 0; y < height; ++y) {
      for (std::size_t x = 0; x < width; ++x) {
        for (std::size_t dy = 0; dy <= 2 * radius; ++dy) {
          for (std::size_t dx = 0; dx <= 2 * radius; ++dx) {
            const std::size_t row = (y + dy + height - radius) % height;
            const std::size_t column = (x + dx + width - radius) % width;
            sums[y * width + x] += field[row * width + column];
          }
        }
      }
    }
    field = sums;
  }
  double squares = 0;
  for (const double value : field) squares += value * value;
  const double scale = std::sqrt(static_cast<double>(field.size()) / squares);
  std::vector<float> scaled;
  scaled.reserve(field.size());
  for (const double value : field) scaled.push_back(static_cast<float>(value * scale));
  return scaled;
}

TEST(NoiseField, IsWhatThreeBoxFiltersOfWhiteNoiseGive) {
  Random random(3);
  const std::vector<float> fast = noise_field(random, 40, 30, 2);
  const std::vector<float> slow = slow_field(3, 40, 30, 2);
  for (std::size_t i = 0; i < fast.size(); ++i) EXPECT_NEAR(fast[i], slow[i], 1e-4);
}

TEST(NoiseField, HasUnitVarianceAndTheCorrelationOfItsRadius) {
  for (const std::uint32_t radius : {1U, 2U, 3U}) {
    Random random(radius);
    const std::vector<float> field = noise_field(random, 640, 480, radius);
    EXPECT_NEAR(correlation(field, 640, 0), 1, 1e-3);
    const double variance_px2 = radius * (radius + 1.0);
    for (const int lag : {1, 2, 4}) {
      EXPECT_NEAR(correlation(field, 640, static_cast<std::size_t>(lag)),
                  std::exp(-(lag * lag) / (4 * variance_px2)), 0.06);
    }
  }
}

TEST(NoiseField, WhiteNoiseIsUncorrelated) {
  Random random(1);
  const std::vector<float> field = noise_field(random, 640, 480, 0);
  EXPECT_NEAR(correlation(field, 640, 1), 0, 0.01);
}

TEST(NoiseField, ABoxLargerThanTheImageIsRefused) {
  Random random(1);
  EXPECT_THROW(static_cast<void>(noise_field(random, 40, 30, 15)), std::invalid_argument);
}

}  // namespace
}  // namespace cleave::render
