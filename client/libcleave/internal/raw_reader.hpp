// SPDX-License-Identifier: BSD-3-Clause
// What all typed readers share. The one place that knows where Cyclone keeps a shared-memory chunk.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "libcleave/internal/topic.hpp"
#include "libcleave/stream.hpp"

namespace cleave {

// Samples kept until they are taken; beyond that the oldest is lost.
struct ReaderDepth {
  int samples;
};

// One received sample, held until destruction: the shared-memory chunk itself, or a private copy of
// what came over the network. Must not outlive its reader.
class RawSample {
 public:
  RawSample(void* serdata, const void* data, void* owned, const dds_topic_descriptor_t* descriptor)
      : serdata_(serdata), data_(data), owned_(owned), descriptor_(descriptor) {}
  RawSample(RawSample&& other) noexcept
      : serdata_(std::exchange(other.serdata_, nullptr)),
        data_(std::exchange(other.data_, nullptr)),
        owned_(std::exchange(other.owned_, nullptr)),
        descriptor_(other.descriptor_) {}
  RawSample& operator=(RawSample&& other) noexcept;
  ~RawSample() { release(); }

  [[nodiscard]] const void* data() const { return data_; }
  [[nodiscard]] bool zero_copy() const { return owned_ == nullptr; }

 private:
  void release() noexcept;
  void* serdata_;  // ddsi_serdata that keeps the chunk
  const void* data_;
  void* owned_;  // heap copy, for samples from the network
  const dds_topic_descriptor_t* descriptor_;
};

class RawReader {
 public:
  RawReader(Stream& stream, const Topic& topic, ReaderDepth depth);
  ~RawReader();
  RawReader(const RawReader&) = delete;
  RawReader& operator=(const RawReader&) = delete;

  // The oldest sample that waits; empty when there is none. Never copies out of shared memory.
  [[nodiscard]] std::optional<RawSample> take();
  [[nodiscard]] unsigned live_writers() const;
  // Writes to an eventfd whenever a sample comes, from now on, and once now, for one may wait
  // already. The descriptor outlives this. Once.
  void notify(int event_descriptor) const;
  // DDS entity, for a wait set.
  [[nodiscard]] std::int32_t entity() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace cleave
