// SPDX-License-Identifier: BSD-3-Clause
#include "recording/ros/depth_image.hpp"

#include <cmath>
#include <cstring>
#include <limits>

#include "recording/cdr/byte_order.hpp"
#include "recording/cloud/measured.hpp"
#include "recording/ros/unusable.hpp"

namespace cleave::recording::ros {
namespace {

constexpr float metres_per_mm = 0.001F;

bool is_in_millimetres(const Image& image) {
  return image.encoding == "16UC1" || image.encoding == "mono16";
}

float metres(std::uint16_t depth_mm) {
  return depth_mm == 0 ? no_measurement : static_cast<float>(depth_mm) * metres_per_mm;
}

float metres(float depth_m) {
  return std::isfinite(depth_m) && depth_m > 0 ? depth_m : no_measurement;
}

// Throws Unusable.
void check_size(const Image& image, std::size_t pixel_bytes) {
  if (image.width == 0 || image.height == 0) throw Unusable("no points", "has no pixels");
  const std::uint64_t row = image.width * std::uint64_t{pixel_bytes};
  const std::uint64_t needed = std::uint64_t{image.height - 1} * image.step + row;
  if (image.step >= row && needed <= image.data.size()) return;
  throw Unusable("damaged", "holds " + std::to_string(image.data.size()) + " bytes in rows of " +
                                std::to_string(image.step) + ", too few for " +
                                std::to_string(image.width) + " x " + std::to_string(image.height) +
                                " pixels");
}

template <class Pixel>
std::vector<float> depth_of_pixels(const Image& image) {
  check_size(image, sizeof(Pixel));
  std::vector<float> depth_m;
  depth_m.reserve(std::size_t{image.width} * image.height);
  for (std::uint32_t v = 0; v < image.height; ++v) {
    const std::byte* from = image.data.data() + std::size_t{v} * image.step;
    for (std::uint32_t u = 0; u < image.width; ++u, from += sizeof(Pixel)) {
      Pixel pixel;
      std::memcpy(&pixel, from, sizeof pixel);
      depth_m.push_back(metres(image.is_bigendian ? byte_swapped(pixel) : pixel));
    }
  }
  return depth_m;
}

}  // namespace

void check_encoding(const Image& image) {
  if (is_in_millimetres(image) || image.encoding == "32FC1") return;
  throw Unusable("encoding", "its encoding '" + image.encoding +
                                 "' is not one of depth: 16UC1, mono16 (mm) or 32FC1 (m)");
}

std::vector<float> depth_of(const Image& image) {
  check_encoding(image);
  return is_in_millimetres(image) ? depth_of_pixels<std::uint16_t>(image)
                                  : depth_of_pixels<float>(image);
}

}  // namespace cleave::recording::ros
