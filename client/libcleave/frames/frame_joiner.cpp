// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/frames/frame_joiner.hpp"

#include <utility>

namespace cleave {

std::optional<CompleteFrame> FrameJoiner::add(CloudSample cloud) {
  return add_pair(joiner_.add(std::move(cloud)));
}

std::optional<CompleteFrame> FrameJoiner::add(LabelSample labels) {
  return add_pair(joiner_.add(std::move(labels)));
}

std::optional<CompleteFrame> FrameJoiner::add_pair(std::optional<JoinedFrame> pair) {
  if (!pair) return std::nullopt;
  const FrameKey frame = PairKey{}(*pair);
  if (auto list = lists_.take(frame)) {
    pairs_.give_up_before(frame);
    return CompleteFrame{std::move(pair->cloud), std::move(pair->labels), std::move(*list)};
  }
  pairs_.keep(std::move(*pair));
  return std::nullopt;
}

std::optional<CompleteFrame> FrameJoiner::add(ListSample list) {
  const FrameKey frame = ListKey{}(list);
  if (auto pair = pairs_.take(frame)) {
    lists_.give_up_before(frame);
    return CompleteFrame{std::move(pair->cloud), std::move(pair->labels), std::move(list)};
  }
  lists_.keep(std::move(list));
  return std::nullopt;
}

}  // namespace cleave
