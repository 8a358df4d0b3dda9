// SPDX-License-Identifier: BSD-3-Clause
// Parts of frames that wait for the rest of theirs, in the order in which they came.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <utility>

#include "idl/frame_key.hpp"

namespace cleave {

// `Key` tells a part's frame.
template <class Part, class Key>
class Waiting {
 public:
  explicit Waiting(std::size_t capacity) : capacity_(capacity) {}

  // The part of this frame, with everything before it given up: each topic is in order, so the rest
  // of those frames was lost.
  [[nodiscard]] std::optional<Part> take(FrameKey frame) {
    std::size_t i = 0;
    while (i < parts_.size() && Key{}(parts_[i]) != frame) ++i;
    if (i == parts_.size()) return std::nullopt;
    std::optional<Part> part(std::move(parts_[i]));
    parts_.erase(parts_.begin(), parts_.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    given_up_ += i;
    return part;
  }
  // Those before a completed frame cannot be completed any more.
  void give_up_before(FrameKey frame) {
    while (!parts_.empty() && Key{}(parts_.front()) < frame) give_up_oldest();
  }
  void keep(Part part) {
    parts_.push_back(std::move(part));
    if (parts_.size() > capacity_) give_up_oldest();
  }
  [[nodiscard]] std::uint64_t given_up() const { return given_up_; }

 private:
  void give_up_oldest() {
    parts_.pop_front();
    ++given_up_;
  }
  std::size_t capacity_;
  std::deque<Part> parts_;
  std::uint64_t given_up_ = 0;
};

}  // namespace cleave
