// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/frames/frame_reader.hpp"

#include <algorithm>
#include <utility>

namespace cleave {
namespace {

// The first frame that one of the samples waiting in `reader` completes.
template <class AnyReader>
std::optional<CompleteFrame> add_all(AnyReader& reader, FrameJoiner& joiner) {
  while (auto sample = reader.take()) {
    if (auto frame = joiner.add(std::move(*sample))) return frame;
  }
  return std::nullopt;
}

}  // namespace

FrameReader::FrameReader(Stream& stream, std::string_view sensor)
    : clouds_(stream, sensor), labels_(stream, sensor), lists_(stream, sensor) {
  ready_.attach(clouds_);
  ready_.attach(labels_);
  ready_.attach(lists_);
}

std::optional<CompleteFrame> FrameReader::take() {
  if (auto frame = add_all(clouds_, joiner_)) return frame;
  if (auto frame = add_all(labels_, joiner_)) return frame;
  return add_all(lists_, joiner_);
}

std::optional<CompleteFrame> FrameReader::next(std::chrono::milliseconds timeout) {
  using Clock = std::chrono::steady_clock;
  using std::chrono::milliseconds;
  const bool for_ever = timeout.count() < 0;
  const Clock::time_point start = Clock::now();
  for (;;) {
    if (auto frame = ready_.take([this] { return take(); })) return frame;
    if (woken_.exchange(false)) return std::nullopt;  // taking may have drained what woke us
    const auto waited = std::chrono::duration_cast<milliseconds>(Clock::now() - start);
    const milliseconds left =
        for_ever ? milliseconds(-1) : std::max(timeout - waited, milliseconds(0));
    if (!ready_.wait(left)) return std::nullopt;
    if (left.count() == 0) return std::nullopt;
  }
}

void FrameReader::wake() {
  woken_ = true;
  ready_.raise();
}

}  // namespace cleave
