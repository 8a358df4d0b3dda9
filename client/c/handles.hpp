// SPDX-License-Identifier: BSD-3-Clause
// What the header's opaque handles are. Each shares what it stands on, so that a garbage collector
// may close them in any order.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "c/any_reader.hpp"
#include "c/cleave.h"
#include "libcleave/cloud_publisher.hpp"
#include "libcleave/frames/frame_reader.hpp"
#include "libcleave/stream.hpp"

namespace cleave::c {

struct Frames {
  explicit Frames(std::shared_ptr<Stream> s, const char* sensor)
      : stream(std::move(s)), reader(*stream, sensor) {}
  std::shared_ptr<Stream> stream;
  FrameReader reader;
};

}  // namespace cleave::c

// NOLINTBEGIN(readability-identifier-naming): the names of cleave.h
struct cleave_stream {
  std::shared_ptr<cleave::Stream> stream;
};

struct cleave_reader {
  std::shared_ptr<cleave::c::AnyReader> reader;
};

struct cleave_frames {
  std::shared_ptr<cleave::c::Frames> frames;
};

struct cleave_sample {
  std::shared_ptr<const void> owner;  // a reader, which must outlive its samples; or nothing
  cleave::c::AnySample sample;
  std::vector<std::byte> cdr;  // once it was asked for
};

struct cleave_publisher {
  std::shared_ptr<cleave::Stream> stream;
  cleave::CloudPublisher publisher;
  std::optional<cleave::CloudLoan> loan;
};
// NOLINTEND(readability-identifier-naming)
