// SPDX-License-Identifier: BSD-3-Clause
#include "recording/cloud/decimate.hpp"

#include <algorithm>

#include "recording/cloud/measured.hpp"

namespace cleave::recording {
Intrinsics Decimator::intrinsics(const Intrinsics& i) const {
  if (i == Intrinsics{}) return i;
  const auto factor = static_cast<float>(factor_);
  return {i.fx / factor, i.fy / factor, (i.cx + .5F) / factor - .5F, (i.cy + .5F) / factor - .5F};
}

const Decimator::Candidate* Decimator::median(const float* xyz, std::uint32_t stride) {
  valid_.clear();
  for (std::uint32_t row = 0; row < factor_; ++row) {
    for (std::uint32_t column = 0; column < factor_; ++column) {
      const float* p = xyz + 3 * (std::size_t{row} * stride + column);
      if (is_measured(p)) valid_.push_back({p[2], p});
    }
  }
  if (valid_.empty()) return nullptr;
  const auto middle = valid_.begin() + static_cast<std::ptrdiff_t>((valid_.size() - 1) / 2);
  // Equal depths in the order of the image, or which one is taken would depend on the library.
  std::stable_sort(valid_.begin(), valid_.end(),
                   [](const Candidate& a, const Candidate& b) { return a.z < b.z; });
  return &*middle;
}

void Decimator::decimate(const float* xyz, std::uint32_t width, std::uint32_t height,
                         const Intrinsics& of_image, float* smaller) {
  const bool pinhole = !(of_image == Intrinsics{});
  const Intrinsics target = intrinsics(of_image);
  for (std::uint32_t v = 0; v < this->height(height); ++v) {
    for (std::uint32_t u = 0; u < this->width(width); ++u, smaller += 3) {
      const std::size_t first = std::size_t{v} * factor_ * width + std::size_t{u} * factor_;
      const Candidate* found = median(xyz + 3 * first, width);
      if (found == nullptr) {
        std::fill_n(smaller, 3, no_measurement);
      } else if (pinhole) {
        smaller[0] = (static_cast<float>(u) - target.cx) / target.fx * found->z;
        smaller[1] = (static_cast<float>(v) - target.cy) / target.fy * found->z;
        smaller[2] = found->z;
      } else {
        std::copy_n(found->point, 3, smaller);
      }
    }
  }
}

}  // namespace cleave::recording
