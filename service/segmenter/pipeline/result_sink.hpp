// SPDX-License-Identifier: BSD-3-Clause
// Where results go, as the pipeline sees it: DDS writers in the daemon, memory in tests.
#pragma once

#include <memory>

#include "libcleave/types.hpp"

namespace cleave::service {

// Memory for one label map, goes back unused unless it is published. Contents start undefined.
class LabelLoan {
 public:
  LabelLoan() = default;
  virtual ~LabelLoan() = default;
  LabelLoan(const LabelLoan&) = delete;
  LabelLoan& operator=(const LabelLoan&) = delete;

  [[nodiscard]] virtual LabelMap& map() = 0;
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

  // Empty when there is no memory: readers hoard it.
  [[nodiscard]] virtual std::unique_ptr<LabelLoan> loan_labels() = 0;
  // False: refused, and lost.
  [[nodiscard]] virtual bool publish(const SegmentList& segments) = 0;
};

}  // namespace cleave::service
