// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/points/mode_filter.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "segmentation/math/multiversion.hpp"
#include "segmentation/math/simd.hpp"

namespace cleave::segmentation {
namespace {

constexpr std::size_t pixels_a_block = 16;  // pixels that are counted at a time

struct Votes {
  std::array<std::int32_t, pixels_a_block> own, all;  // pixels in the window
};

struct Lanes {
  Float8 depth_m;
  Int8 segment, own, all;
};

// Adds one of a window's pixels, for eight windows side by side; true is -1.
inline __attribute__((always_inline)) void count_vote(const std::uint32_t* segment,
                                                      const float* depth_m, float depth_gate_m,
                                                      Lanes& lanes) {
  Float8 step_m;
  Int8 other;
  load(depth_m, step_m);
  load(segment, other);
  step_m -= lanes.depth_m;
  const Int8 counts = (step_m <= depth_gate_m) & (step_m >= -depth_gate_m);
  lanes.all -= counts;
  lanes.own -= counts & (other == lanes.segment);
}

// Where nothing was measured, depth is infinite: no gate lets it in.
CLEAVE_MULTIVERSION
void count_votes(const std::uint32_t* segment, const float* depth_m, std::ptrdiff_t stride,
                 std::ptrdiff_t radius, float depth_gate_m, Votes& votes) {
  Lanes left{}, right{};
  load(segment, left.segment);
  load(depth_m, left.depth_m);
  load(segment + 8, right.segment);
  load(depth_m + 8, right.depth_m);
  for (std::ptrdiff_t dy = -radius; dy <= radius; ++dy) {
    for (std::ptrdiff_t offset = dy * stride - radius; offset <= dy * stride + radius; ++offset) {
      count_vote(segment + offset, depth_m + offset, depth_gate_m, left);
      count_vote(segment + offset + 8, depth_m + offset + 8, depth_gate_m, right);
    }
  }
  store(left.own, votes.own.data());
  store(left.all, votes.all.data());
  store(right.own, votes.own.data() + 8);
  store(right.all, votes.all.data() + 8);
}

}  // namespace

std::uint32_t ModeFilter::mode_around(const PixelImage& image, std::size_t middle,
                                      std::uint32_t radius, float depth_gate_m) {
  counts_.assign(1, {image.segment[middle], 0});
  std::size_t current = 0;
  const std::size_t stride = image.layout.stride;
  for (std::size_t row = middle - radius * stride; row <= middle + radius * stride; row += stride) {
    for (std::size_t i = row - radius; i <= row + radius; ++i) {
      if (!(std::abs(image.z[i] - image.z[middle]) <= depth_gate_m)) continue;
      const std::uint32_t segment = image.segment[i];
      if (counts_[current].segment != segment) {
        for (current = 0; current < counts_.size() && counts_[current].segment != segment;) {
          ++current;
        }
        if (current == counts_.size()) counts_.push_back({segment, 0});
      }
      ++counts_[current].pixels;
    }
  }

  Count mode = counts_.front();
  for (const Count& count : counts_) {
    const bool tie_lower = count.pixels == mode.pixels && mode.segment != counts_[0].segment &&
                           count.segment < mode.segment;
    if (count.pixels > mode.pixels || tie_lower) mode = count;
  }
  return mode.segment;
}

void ModeFilter::filter_block(const PixelImage& image, std::size_t begin, std::size_t end,
                              std::uint32_t radius, float depth_gate_m) {
  Votes votes;
  count_votes(image.segment.data() + begin, image.z.data() + begin,
              static_cast<std::ptrdiff_t>(image.layout.stride), static_cast<std::ptrdiff_t>(radius),
              depth_gate_m, votes);
  for (std::size_t i = begin; i < end; ++i) {
    if (image.segment[i] == PixelImage::no_segment) continue;
    if (2 * votes.own[i - begin] >= votes.all[i - begin]) continue;
    const std::uint32_t mode = mode_around(image, i, radius, depth_gate_m);
    if (mode != image.segment[i]) changes_.push_back({i, mode});
  }
}

void ModeFilter::filter(PixelImage& image, std::span<const PixelSpan> mixed, std::uint32_t radius,
                        float depth_gate_m) {
  changes_.clear();
  for (const PixelSpan& span : mixed) {
    for (std::size_t i = span.begin; i < span.end; i += pixels_a_block) {
      filter_block(image, i, std::min(i + pixels_a_block, span.end), radius, depth_gate_m);
    }
  }
  for (const Change& change : changes_) image.segment[change.pixel] = change.segment;
}

}  // namespace cleave::segmentation
