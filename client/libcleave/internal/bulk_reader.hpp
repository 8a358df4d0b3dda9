// SPDX-License-Identifier: BSD-3-Clause
// What readers of clouds and of label maps share: both topics of the kind, and samples in place.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "libcleave/internal/bulk_kinds.hpp"
#include "libcleave/internal/raw_reader.hpp"
#include "libcleave/internal/topic.hpp"
#include "libcleave/stream.hpp"
#include "libcleave/types.hpp"

namespace cleave {

// A received sample, valid until destruction, which must come before its reader's; while it lives
// its chunk is out of the pool, so hold few (the pool is sized for the readers' history plus a
// handful). Who wrote it still has the memory: believe a copy of the header.
template <class Kind>
class BulkSample {
 public:
  BulkSample(RawSample raw, bool large) : raw_(std::move(raw)), large_(large) {}

  [[nodiscard]] const FrameHeader& header() const {
    return *static_cast<const FrameHeader*>(raw_.data());
  }
  // True: this is the writer's own memory. False: a private copy of what the network brought.
  [[nodiscard]] bool zero_copy() const { return raw_.zero_copy(); }
  [[nodiscard]] bool large() const { return large_; }
  // All that the type has room for, whatever the header says.
  [[nodiscard]] std::span<const typename Kind::Value> room() const {
    const auto* const first = reinterpret_cast<const typename Kind::Value*>(
        static_cast<const std::byte*>(raw_.data()) + Kind::offset);
    return {first, capacity_of(large_) * Kind::values_a_point};
  }

 protected:
  // Of the header's points; empty where it announces more than there is room for.
  [[nodiscard]] std::span<const typename Kind::Value> values() const {
    const std::uint64_t points = point_count(header());
    if (points > capacity_of(large_)) return {};
    return room().first(static_cast<std::size_t>(points) * Kind::values_a_point);
  }
  [[nodiscard]] const void* data() const { return raw_.data(); }

 private:
  RawSample raw_;
  bool large_;
};

// Reads both topics of a kind, whichever the sensor publishes on. One thread takes; wait with a
// WaitSet.
template <class Kind, class SampleType>
class BulkReader {
 public:
  // Throws std::runtime_error.
  BulkReader(Stream& stream, std::string_view sensor)
      : BulkReader(stream, sensor,
                   ReaderDepth{topic_of<typename Kind::Small>(sensor).history_depth}) {}
  BulkReader(Stream& stream, std::string_view sensor, ReaderDepth depth)
      : small_(stream, topic_of<typename Kind::Small>(sensor), depth),
        large_(stream, topic_of<typename Kind::Large>(sensor), depth) {}

  // The oldest sample that waits; empty when there is none.
  [[nodiscard]] std::optional<SampleType> take() {
    if (auto raw = small_.take()) return SampleType(std::move(*raw), false);
    if (auto raw = large_.take()) return SampleType(std::move(*raw), true);
    return std::nullopt;
  }
  // Writers that are alive now: a killed one leaves within its lease of 1 s.
  [[nodiscard]] unsigned live_writers() const {
    return std::max(small_.live_writers(), large_.live_writers());
  }
  [[nodiscard]] const RawReader& small() const { return small_; }
  [[nodiscard]] const RawReader& large() const { return large_; }

 private:
  RawReader small_;
  RawReader large_;
};

}  // namespace cleave
