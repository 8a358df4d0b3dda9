#include "segmentation/mode_filter.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "segmentation/multiversion.hpp"

namespace cleave::segmentation {
namespace {

constexpr std::uint32_t none = SegmentImage::no_segment;
constexpr std::size_t block = 16;  // pixels that are counted at a time

struct Votes {
  std::array<std::int32_t, block> own{}, all{};  // pixels in the window
};

CLEAVE_MULTIVERSION
void count_votes(const std::uint32_t* segment, const float* depth_m, std::ptrdiff_t stride,
                 std::ptrdiff_t radius, float depth_gate_m, Votes& result) {
  Votes votes;
  for (std::ptrdiff_t dy = -radius; dy <= radius; ++dy) {
    for (std::ptrdiff_t offset = dy * stride - radius; offset <= dy * stride + radius; ++offset) {
      const std::uint32_t* other = segment + offset;
      const float* other_m = depth_m + offset;
      for (std::size_t i = 0; i < block; ++i) {
        const int counts = std::abs(other_m[i] - depth_m[i]) <= depth_gate_m ? 1 : 0;
        votes.all[i] += counts;
        votes.own[i] += other[i] == segment[i] ? counts : 0;
      }
    }
  }
  result = votes;
}

CLEAVE_MULTIVERSION
void mark_differences(const std::uint32_t* __restrict segment, std::size_t stride,
                      std::size_t count, std::uint8_t* __restrict differs) {
  for (std::size_t i = 0; i < count; ++i) {
    differs[i] = static_cast<std::uint8_t>(segment[i] != segment[i + 1] ||
                                           segment[i] != segment[i + stride]);
  }
}

CLEAVE_MULTIVERSION
void merge_shifted(const std::uint8_t* __restrict marks, std::size_t shift, std::size_t count,
                   std::uint8_t* __restrict result) {
  for (std::size_t i = 0; i < count; ++i) {
    result[i] = static_cast<std::uint8_t>(marks[i] | marks[i - shift] | marks[i + shift]);
  }
}

}  // namespace

void ModeFilter::pad(const SegmentImage& image, std::uint32_t radius) {
  stride_ = image.width + radius + block;
  const std::size_t border = radius * stride_ + radius;
  const std::size_t size = (image.height + 2 * std::size_t{radius} + 2) * stride_ + block;
  segment_.assign(size, none);
  filled_.assign(size, none);
  depth_m_.assign(size, std::numeric_limits<float>::infinity());
  // A window with two segments has two neighbouring pixels that differ. That stays true when pixels
  // without a segment are given any: here the last one before them.
  std::uint32_t last = none;
  for (std::uint32_t row = 0; row < image.height; ++row) {
    const std::size_t from = std::size_t{row} * image.width;
    const std::size_t to = border + row * stride_;
    for (std::uint32_t column = 0; column < image.width; ++column) {
      const std::uint32_t segment = image.segment[from + column];
      last = segment == none ? last : segment;
      segment_[to + column] = segment;
      filled_[to + column] = last;
      if (segment != none) depth_m_[to + column] = image.depth_m[from + column];
    }
    std::fill_n(filled_.begin() + static_cast<std::ptrdiff_t>(to + image.width), radius + block,
                last);
  }
}

// In steps that double: marks that have spread by r on all sides spread by up to r more at once.
void ModeFilter::spread_marks(std::size_t step, std::uint32_t radius) {
  for (std::uint32_t done = 0; done < radius;) {
    const std::uint32_t further = std::min(std::max(done, 1U), radius - done);
    const std::size_t shift = further * step;
    spread_.resize(mixed_.size());
    std::copy(mixed_.begin(), mixed_.end(), spread_.begin());
    if (mixed_.size() > 2 * shift) {
      merge_shifted(mixed_.data() + shift, shift, mixed_.size() - 2 * shift,
                    spread_.data() + shift);
    }
    mixed_.swap(spread_);
    done += further;
  }
}

void ModeFilter::mark_mixed_windows(std::uint32_t radius) {
  mixed_.assign(filled_.size(), 0);
  mark_differences(filled_.data(), stride_, filled_.size() - stride_ - 1, mixed_.data());
  // A mark stands left of or above its other pixel: one step more reaches both.
  spread_marks(1, radius + 1);
  spread_marks(stride_, radius + 1);
}

std::uint32_t ModeFilter::mode_around(std::size_t middle, std::uint32_t radius,
                                      float depth_gate_m) {
  counts_.assign(1, {segment_[middle], 0});
  std::size_t current = 0;
  for (std::size_t row = middle - radius * stride_; row <= middle + radius * stride_;
       row += stride_) {
    for (std::size_t i = row - radius; i <= row + radius; ++i) {
      if (!(std::abs(depth_m_[i] - depth_m_[middle]) <= depth_gate_m)) continue;
      const std::uint32_t segment = segment_[i];
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

void ModeFilter::filter_block(std::size_t begin, std::size_t end, std::uint32_t radius,
                              float depth_gate_m, std::uint32_t* result) {
  Votes votes;
  count_votes(segment_.data() + begin, depth_m_.data() + begin,
              static_cast<std::ptrdiff_t>(stride_), static_cast<std::ptrdiff_t>(radius),
              depth_gate_m, votes);
  for (std::size_t i = begin; i < end; ++i) {
    const bool certain = 2 * votes.own[i - begin] >= votes.all[i - begin];
    if (mixed_[i] == 0 || segment_[i] == none || certain) continue;
    result[i - begin] = mode_around(i, radius, depth_gate_m);
  }
}

void ModeFilter::filter(SegmentImage& image, std::uint32_t radius, float depth_gate_m) {
  pad(image, radius);
  mark_mixed_windows(radius);
  for (std::uint32_t row = 0; row < image.height; ++row) {
    const std::size_t begin = (row + std::size_t{radius}) * stride_ + radius;
    const std::size_t end = begin + image.width;
    std::uint32_t* result = image.segment.data() + std::size_t{row} * image.width;
    for (std::size_t i = begin; i < end;) {
      if (mixed_[i] == 0) {
        ++i;
        continue;
      }
      const std::size_t block_end = std::min(i + block, end);
      filter_block(i, block_end, radius, depth_gate_m, result + (i - begin));
      i = block_end;
    }
  }
}

}  // namespace cleave::segmentation
