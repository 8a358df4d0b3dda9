// SPDX-License-Identifier: BSD-3-Clause
// What all typed writers share: a DDS writer, its loans and its events in the log.
#pragma once

#include <memory>

#include "libcleave/internal/topic.hpp"
#include "libcleave/stream.hpp"

namespace cleave {

// Samples kept for readers that are slow over the network.
struct WriterDepth {
  int samples;
};

class RawWriter {
 public:
  RawWriter(Stream& stream, const Topic& topic, WriterDepth depth);
  ~RawWriter();
  RawWriter(const RawWriter&) = delete;
  RawWriter& operator=(const RawWriter&) = delete;

  [[nodiscard]] void* loan();  // nullptr: the pool is exhausted
  void give_back(void* loan);
  [[nodiscard]] bool publish_loan(void* loan);
  [[nodiscard]] bool publish(const void* sample);
  // Readers that get what is published now: over shared memory none in the first 250 ms of the
  // first one, which RouDi connects only then.
  [[nodiscard]] unsigned matched_readers() const;
  [[nodiscard]] bool zero_copy() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace cleave
