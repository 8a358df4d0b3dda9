// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/renderer/noise_field.hpp"

#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>

namespace cleave::render {
namespace {

// Running sums of 2 radius + 1 neighbours along a row; the first and last values are neighbours.
void box_sum_along_row(std::span<const float> in, std::span<float> out, std::size_t radius) {
  const std::size_t size = in.size();
  float sum = in[0];
  for (std::size_t k = 1; k <= radius; ++k) sum += in[k] + in[size - k];
  for (std::size_t x = 0; x < size; ++x) {
    out[x] = sum;
    const std::size_t entering = x + radius + 1;
    const std::size_t leaving = x + size - radius;
    sum += in[entering < size ? entering : entering - size] -
           in[leaving < size ? leaving : leaving - size];
  }
}

class BoxFilter {
 public:
  BoxFilter(std::size_t width, std::size_t height, std::size_t radius)
      : width_(width), height_(height), radius_(radius), scratch_(width * height), sums_(width) {}

  void apply(std::vector<float>& image) {
    for (std::size_t y = 0; y < height_; ++y) {
      box_sum_along_row(row(image, y), row(scratch_, y), radius_);
    }
    sum_columns(image);
  }

 private:
  std::span<float> row(std::vector<float>& image, std::size_t y) const {
    return {image.data() + (y % height_) * width_, width_};
  }

  // All columns of a row at once, which compilers turn into vector instructions.
  void sum_columns(std::vector<float>& out) {
    sums_.assign(width_, 0);
    for (std::size_t k = 0; k <= 2 * radius_; ++k) {
      const std::span<const float> entering = row(scratch_, k + height_ - radius_);
      for (std::size_t x = 0; x < width_; ++x) sums_[x] += entering[x];
    }
    for (std::size_t y = 0; y < height_; ++y) {
      const std::span<const float> entering = row(scratch_, y + radius_ + 1);
      const std::span<const float> leaving = row(scratch_, y + height_ - radius_);
      const std::span<float> target = row(out, y);
      for (std::size_t x = 0; x < width_; ++x) {
        target[x] = sums_[x];
        sums_[x] += entering[x] - leaving[x];
      }
    }
  }

  std::size_t width_, height_, radius_;
  std::vector<float> scratch_;
  std::vector<float> sums_;
};

void scale_to_unit_variance(std::vector<float>& image) {
  double sum = 0;
  for (const float value : image) sum += double{value} * value;
  const auto scale = static_cast<float>(1 / std::sqrt(sum / static_cast<double>(image.size())));
  for (float& value : image) value *= scale;
}

}  // namespace

std::vector<float> noise_field(Random& random, std::uint32_t width, std::uint32_t height,
                               std::uint32_t radius) {
  if (2 * std::uint64_t{radius} + 1 > width || 2 * std::uint64_t{radius} + 1 > height) {
    throw std::invalid_argument("a noise field's box filter is larger than its image");
  }
  std::vector<float> image(std::size_t{width} * height);
  for (float& value : image) value = random.normal();
  if (radius > 0) {
    BoxFilter filter(width, height, radius);
    for (int pass = 0; pass < 3; ++pass) filter.apply(image);
  }
  scale_to_unit_variance(image);
  return image;
}

}  // namespace cleave::render
