// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/renderer/view/visible_parts.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace cleave::render {
namespace {

constexpr std::int64_t largest_gap_px = 3;
constexpr float largest_step = 0.03F;  // in depth, relative
constexpr std::size_t smallest_part_px = 120;
constexpr std::uint16_t parts_per_surface = 10;
// No camera of this kind measures a surface at such an angle of incidence.
constexpr float smallest_cosine = 0.10F;

using PixelList = std::vector<std::uint32_t>;

struct PartOfSurface {
  std::uint16_t surface;
  PixelList pixels;
};

class PartFinder {
 public:
  explicit PartFinder(const RayCast& rays) : rays_(rays), open_(rays.measurable) {
    for (std::size_t i = 0; i < open_.size(); ++i) {
      if (rays.cosine[i] < smallest_cosine) open_[i] = 0;
    }
  }

  std::vector<PartOfSurface> find() {
    std::vector<PartOfSurface> parts;
    for (std::uint32_t i = 0; i < open_.size(); ++i) {
      if (open_[i] != 0) parts.push_back({rays_.surface[i], grow(i)});
    }
    return parts;
  }

 private:
  PixelList grow(std::uint32_t seed) {
    open_[seed] = 0;
    PixelList pixels = {seed};
    for (std::size_t next = 0; next < pixels.size(); ++next) add_neighbours(pixels[next], pixels);
    return pixels;
  }

  void add_neighbours(std::uint32_t centre, PixelList& pixels) {
    const std::int64_t x = centre % rays_.width;
    const std::int64_t y = centre / rays_.width;
    const std::int64_t x_last = std::min<std::int64_t>(x + largest_gap_px, rays_.width - 1);
    const std::int64_t y_last = std::min<std::int64_t>(y + largest_gap_px, rays_.height - 1);
    for (std::int64_t row = std::max<std::int64_t>(y - largest_gap_px, 0); row <= y_last; ++row) {
      for (std::int64_t col = std::max<std::int64_t>(x - largest_gap_px, 0); col <= x_last; ++col) {
        const auto i = static_cast<std::uint32_t>(row * rays_.width + col);
        if (open_[i] == 0 || !belong_together(centre, i)) continue;
        open_[i] = 0;
        pixels.push_back(i);
      }
    }
  }

  bool belong_together(std::uint32_t a, std::uint32_t b) const {
    return rays_.surface[a] == rays_.surface[b] &&
           std::abs(rays_.depth_m[a] - rays_.depth_m[b]) <= largest_step * rays_.depth_m[a];
  }

  const RayCast& rays_;
  std::vector<std::uint8_t> open_;  // 1 = can be measured, and is in no part yet
};

std::uint16_t first_label(std::uint16_t surface) {
  return surface == table_surface ? 1 : static_cast<std::uint16_t>(surface * 10);
}

std::uint16_t label_count(std::uint16_t surface) {
  return surface == table_surface ? parts_per_surface - 1 : parts_per_surface;
}

}  // namespace

std::vector<std::uint16_t> label_visible_parts(const RayCast& rays) {
  std::vector<PartOfSurface> parts = PartFinder(rays).find();
  std::ranges::stable_sort(parts, std::ranges::greater{},
                           [](const PartOfSurface& part) { return part.pixels.size(); });
  std::vector<std::uint16_t> labels(rays.surface.size(), 0);
  std::map<std::uint16_t, std::uint16_t> labels_used;
  for (const PartOfSurface& part : parts) {
    if (part.pixels.size() < smallest_part_px) break;
    std::uint16_t& used = labels_used[part.surface];
    if (used == label_count(part.surface)) continue;
    const auto label = static_cast<std::uint16_t>(first_label(part.surface) + used);
    ++used;
    for (const std::uint32_t i : part.pixels) labels[i] = label;
  }
  return labels;
}

}  // namespace cleave::render
