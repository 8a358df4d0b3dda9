// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/internal/large_chunks.hpp"

#include <spdlog/spdlog.h>

#include "libcleave/internal/roudi/roudi_access.hpp"

namespace cleave {

bool LargeChunks::there() {
  const std::lock_guard lock(mutex_);
  if (!asked_) {
    asked_ = true;
    obstacle_ = obstacle_of_pools(bytes_);
    if (!obstacle_.empty()) spdlog::error("frames of more than 640 x 480 points: {}", obstacle_);
  }
  return obstacle_.empty();
}

std::string LargeChunks::obstacle() const {
  const std::lock_guard lock(mutex_);
  return obstacle_;
}

}  // namespace cleave
