#include "segmentation/mode_filter.hpp"

#include <algorithm>
#include <cmath>

namespace cleave::segmentation {
namespace {

// The two do not overlap; the compiler must know to vectorise this.
void or_into(std::uint8_t* __restrict target, const std::uint8_t* __restrict source,
             std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) target[i] |= source[i];
}

}  // namespace

// A window with two segments has two neighbouring pixels that differ. That stays true when pixels
// without a segment are given any: here the last one before them.
void ModeFilter::mark_mixed_windows(const SegmentImage& image, std::uint32_t radius) {
  const std::size_t width = image.width;
  const std::size_t pixels = image.segment.size();
  filled_ = image.segment;
  for (std::size_t i = 1; i < pixels; ++i) {
    if (filled_[i] == SegmentImage::no_segment) filled_[i] = filled_[i - 1];
  }
  mixed_.assign(pixels, 0);
  for (std::size_t i = 0; i + 1 < pixels; ++i) {
    mixed_[i] = static_cast<std::uint8_t>(filled_[i] != filled_[i + 1]);
  }
  for (std::size_t i = 0; i + width < pixels; ++i) {
    mixed_[i] |= static_cast<std::uint8_t>(filled_[i] != filled_[i + width]);
  }
  spread_marks(image, radius);
}

// Along the rows without regard to their ends, which marks a few windows too many.
void ModeFilter::spread_marks(const SegmentImage& image, std::uint32_t radius) {
  const std::size_t pixels = mixed_.size();
  for (const std::size_t step : {std::size_t{1}, std::size_t{image.width}}) {
    spread_ = mixed_;
    for (std::size_t offset = step; offset <= radius * step && offset < pixels; offset += step) {
      or_into(spread_.data(), mixed_.data() + offset, pixels - offset);
      or_into(spread_.data() + offset, mixed_.data(), pixels - offset);
    }
    mixed_.swap(spread_);
  }
}

std::uint32_t ModeFilter::mode_around(const SegmentImage& image, std::uint32_t column,
                                      std::uint32_t row, std::uint32_t radius, float depth_gate_m) {
  const std::size_t middle = std::size_t{row} * image.width + column;
  const std::uint32_t first_row = row - std::min(row, radius);
  const std::uint32_t last_row = std::min(row + radius, image.height - 1);
  const std::uint32_t first_column = column - std::min(column, radius);
  const std::uint32_t last_column = std::min(column + radius, image.width - 1);

  counts_.assign(1, {image.segment[middle], 0});
  std::size_t current = 0;
  for (std::uint32_t r = first_row; r <= last_row; ++r) {
    for (std::uint32_t c = first_column; c <= last_column; ++c) {
      const std::size_t i = std::size_t{r} * image.width + c;
      const std::uint32_t segment = image.segment[i];
      if (segment == SegmentImage::no_segment ||
          std::abs(image.depth_m[i] - image.depth_m[middle]) > depth_gate_m) {
        continue;
      }
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

void ModeFilter::filter(SegmentImage& image, std::uint32_t radius, float depth_gate_m) {
  mark_mixed_windows(image, radius);
  filtered_ = image.segment;
  for (std::uint32_t row = 0; row < image.height; ++row) {
    for (std::uint32_t column = 0; column < image.width; ++column) {
      const std::size_t i = std::size_t{row} * image.width + column;
      if (mixed_[i] == 0 || image.segment[i] == SegmentImage::no_segment) continue;
      filtered_[i] = mode_around(image, column, row, radius, depth_gate_m);
    }
  }
  image.segment.swap(filtered_);
}

}  // namespace cleave::segmentation
