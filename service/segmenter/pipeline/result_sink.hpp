// SPDX-License-Identifier: BSD-3-Clause
// Where results go, as the pipeline sees it: DDS writers in the daemon, memory in tests.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "libcleave/types.hpp"

namespace cleave::service {

// Memory for one label map, goes back unused unless it is published. Contents start undefined.
class LabelMemory {
 public:
  LabelMemory() = default;
  virtual ~LabelMemory() = default;
  LabelMemory(const LabelMemory&) = delete;
  LabelMemory& operator=(const LabelMemory&) = delete;

  [[nodiscard]] virtual FrameHeader& header() = 0;
  [[nodiscard]] virtual std::int64_t& cloud_publication_time_ns() = 0;
  // Room for as many labels as were asked for, and more.
  [[nodiscard]] virtual std::span<std::uint16_t> room() = 0;
  // Once. False: refused, and lost.
  [[nodiscard]] virtual bool publish() = 0;
};

// Loans from several threads at once; publishes from one at a time. Outlives its loans.
class ResultSink {
 public:
  // Loans that may be out at once: what a DDS writer has.
  static constexpr std::size_t max_loans = 8;

  ResultSink() = default;
  virtual ~ResultSink() = default;
  ResultSink(const ResultSink&) = delete;
  ResultSink& operator=(const ResultSink&) = delete;

  // For a map of so many points. Empty when there is no memory: no_memory() says why.
  [[nodiscard]] virtual std::unique_ptr<LabelMemory> loan_labels(std::uint64_t points) = 0;
  [[nodiscard]] virtual std::string no_memory() const = 0;
  // False: refused, and lost.
  [[nodiscard]] virtual bool publish(const SegmentList& segments) = 0;
};

}  // namespace cleave::service
