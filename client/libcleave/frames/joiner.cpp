// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/frames/joiner.hpp"

#include <utility>

namespace cleave {

std::optional<JoinedFrame> Joiner::add(CloudSample cloud) {
  const FrameKey frame = key_of(cloud.header());
  if (auto labels = labels_.take(frame)) {
    clouds_.give_up_before(frame);
    return JoinedFrame{std::move(cloud), std::move(*labels)};
  }
  clouds_.keep(std::move(cloud));
  return std::nullopt;
}

std::optional<JoinedFrame> Joiner::add(LabelSample labels) {
  const FrameKey frame = key_of(labels.header());
  if (auto cloud = clouds_.take(frame)) {
    labels_.give_up_before(frame);
    return JoinedFrame{std::move(*cloud), std::move(labels)};
  }
  labels_.keep(std::move(labels));
  return std::nullopt;
}

}  // namespace cleave
