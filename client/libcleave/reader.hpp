// SPDX-License-Identifier: BSD-3-Clause
// Typed readers. A sample that came over shared memory is handed out in place: it is never copied.
#pragma once

#include <optional>
#include <string_view>
#include <utility>

#include "libcleave/internal/raw_reader.hpp"
#include "libcleave/internal/topic.hpp"
#include "libcleave/stream.hpp"
#include "libcleave/types.hpp"

namespace cleave {

// A received sample, valid until destruction; while it lives its chunk is out of the pool, so hold
// few (the pool is sized for the readers' history plus a handful).
template <class T>
class Sample {
 public:
  explicit Sample(RawSample raw) : raw_(std::move(raw)) {}
  const T& operator*() const { return *static_cast<const T*>(raw_.data()); }
  const T* operator->() const { return static_cast<const T*>(raw_.data()); }
  // True: this is the writer's own memory. False: a private copy of what the network brought.
  [[nodiscard]] bool zero_copy() const { return raw_.zero_copy(); }

 private:
  RawSample raw_;
};

// One thread takes; wait with a WaitSet.
template <class T>
class Reader {
 public:
  // `sensor` names the topic (topic.hpp); it is ignored for NodeStatus. Throws std::runtime_error.
  Reader(Stream& stream, std::string_view sensor)
      : raw_(stream, topic_of<T>(sensor), ReaderDepth{topic_of<T>(sensor).history_depth}) {}
  Reader(Stream& stream, std::string_view sensor, ReaderDepth depth)
      : raw_(stream, topic_of<T>(sensor), depth) {}

  // The oldest sample that waits; empty when there is none.
  [[nodiscard]] std::optional<Sample<T>> take() {
    std::optional<RawSample> raw = raw_.take();
    if (!raw) return std::nullopt;
    return Sample<T>(std::move(*raw));
  }
  // Writers that are alive now: a killed one leaves within its lease of 1 s.
  [[nodiscard]] unsigned live_writers() const { return raw_.live_writers(); }
  [[nodiscard]] const RawReader& raw() const { return raw_; }

 private:
  RawReader raw_;
};

}  // namespace cleave
