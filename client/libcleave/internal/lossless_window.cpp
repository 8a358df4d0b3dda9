// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/internal/lossless_window.hpp"

#include <algorithm>
#include <utility>

namespace cleave {

void LosslessWindow::update(Clock::time_point now, unsigned segmenters) {
  const bool is_back = std::exchange(segmenters_, segmenters) == 0 && segmenters > 0;
  if (frames_.empty() || segmenters == 0) return;
  if (is_back) {
    patience_ = first_patience;
    go_back(now);
  } else if (now - last_progress_ >= patience_) {
    patience_ = std::min(2 * patience_, last_patience);
    go_back(now);
  }
}

void LosslessWindow::go_back(Clock::time_point now) {
  for (Entry& entry : frames_) entry.sent = false;
  opened_ = false;
  last_progress_ = now;
}

std::optional<FrameKey> LosslessWindow::to_resend() const {
  if (sent() >= limit()) return std::nullopt;
  const auto entry =
      std::find_if(frames_.begin(), frames_.end(), [](const Entry& e) { return !e.sent; });
  if (entry == frames_.end()) return std::nullopt;
  return entry->frame;
}

// New frames wait until all those before them are on their way again.
bool LosslessWindow::has_room() const {
  return frames_.size() < limit() && sent() == frames_.size();
}

void LosslessWindow::published(FrameKey frame, Clock::time_point now) {
  if (sent() == 0) last_progress_ = now;
  const auto entry = std::find_if(frames_.begin(), frames_.end(),
                                  [&](const Entry& e) { return e.frame == frame; });
  if (entry == frames_.end()) {
    frames_.push_back({frame, true});
  } else {
    entry->sent = true;
  }
}

void LosslessWindow::returned(FrameKey frame, Clock::time_point now) {
  const auto removed = std::erase_if(frames_, [&](const Entry& e) { return e.frame == frame; });
  if (removed == 0) return;
  opened_ = true;
  patience_ = first_patience;
  last_progress_ = now;
}

bool LosslessWindow::contains(FrameKey frame) const {
  return std::any_of(frames_.begin(), frames_.end(),
                     [&](const Entry& e) { return e.frame == frame; });
}

std::size_t LosslessWindow::sent() const {
  return static_cast<std::size_t>(
      std::count_if(frames_.begin(), frames_.end(), [](const Entry& e) { return e.sent; }));
}

}  // namespace cleave
