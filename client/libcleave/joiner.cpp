// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/joiner.hpp"

#include "idl/frame_key.hpp"

namespace cleave {
namespace {

// The partner of `frame`, taken out of `waiting` together with everything before it.
template <class T>
std::optional<T> take_partner(std::deque<T>& waiting, const FrameHeader& frame,
                                      std::uint64_t& given_up) {
  std::size_t i = 0;
  while (i < waiting.size() && key_of(waiting[i].header()) != key_of(frame)) ++i;
  if (i == waiting.size()) return std::nullopt;
  T partner = std::move(waiting[i]);
  waiting.erase(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(i) + 1);
  given_up += i;
  return partner;
}

// Those before a completed frame cannot be completed any more: each topic is in order.
template <class T>
void give_up_before(std::deque<T>& waiting, const FrameHeader& frame,
                    std::uint64_t& given_up) {
  while (!waiting.empty() && waiting.front().header().epoch == frame.epoch &&
         waiting.front().header().frame_id < frame.frame_id) {
    waiting.pop_front();
    ++given_up;
  }
}

template <class T>
void keep(std::deque<T>& waiting, T sample, std::size_t capacity,
          std::uint64_t& given_up) {
  waiting.push_back(std::move(sample));
  if (waiting.size() > capacity) {
    waiting.pop_front();
    ++given_up;
  }
}

}  // namespace

std::optional<JoinedFrame> Joiner::add(CloudSample cloud) {
  const FrameHeader& frame = cloud.header();
  if (auto labels = take_partner(labels_, frame, unpaired_)) {
    give_up_before(clouds_, frame, unpaired_);
    return JoinedFrame{std::move(cloud), std::move(*labels)};
  }
  keep(clouds_, std::move(cloud), capacity_, unpaired_);
  return std::nullopt;
}

std::optional<JoinedFrame> Joiner::add(LabelSample labels) {
  const FrameHeader& frame = labels.header();
  if (auto cloud = take_partner(clouds_, frame, unpaired_)) {
    give_up_before(labels_, frame, unpaired_);
    return JoinedFrame{std::move(*cloud), std::move(labels)};
  }
  keep(labels_, std::move(labels), capacity_, unpaired_);
  return std::nullopt;
}

}  // namespace cleave
