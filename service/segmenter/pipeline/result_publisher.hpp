// SPDX-License-Identifier: BSD-3-Clause
// The last step of a frame: its results go out and its end is entered in the books.
#pragma once

#include <string>

#include "libcleave/process/logging.hpp"
#include "segmenter/pipeline/frame.hpp"
#include "segmenter/pipeline/frame_ledger.hpp"
#include "segmenter/pipeline/latency_window.hpp"
#include "segmenter/pipeline/problem_log.hpp"
#include "segmenter/pipeline/result_sink.hpp"
#include "segmenter/pipeline/segment_list_buffer.hpp"

namespace cleave::service {

// One thread at a time. All that it is given outlives it.
class ResultPublisher {
 public:
  ResultPublisher(ResultSink& sink, FrameLedger& ledger, LatencyWindow& latency,
                  ProblemLog& problems)
      : sink_(sink), ledger_(ledger), latency_(latency), problems_(problems) {}

  // The label map first: who has the segment list knows that the labels are on the way.
  void publish(FinishedFrame& frame);

 private:
  [[nodiscard]] bool publish_labels(FinishedFrame& frame);
  [[nodiscard]] bool publish_segments(const FinishedFrame& frame);
  void count_refused(const FinishedFrame& frame);
  void count_rejected(const FinishedFrame& frame);

  ResultSink& sink_;
  FrameLedger& ledger_;
  LatencyWindow& latency_;
  ProblemLog& problems_;
  LogLimiter refused_;
  LogLimiter rejected_;
  SegmentListBuffer buffer_;
};

}  // namespace cleave::service
