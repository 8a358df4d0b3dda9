// SPDX-License-Identifier: BSD-3-Clause
// One sensor's frames from cloud to published segments. Knows no DDS: clouds are given to it, and
// results go to a ResultSink.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "libcleave/process/logging.hpp"
#include "libcleave/types.hpp"
#include "segmentation/cloud_view.hpp"
#include "segmentation/result_check.hpp"
#include "segmentation/segmentation.hpp"
#include "segmenter/pipeline/frame.hpp"
#include "segmenter/pipeline/frame_ledger.hpp"
#include "segmenter/pipeline/frame_queue.hpp"
#include "segmenter/pipeline/in_order_publisher.hpp"
#include "segmenter/pipeline/latency_window.hpp"
#include "segmenter/pipeline/problem_log.hpp"
#include "segmenter/pipeline/result_publisher.hpp"
#include "segmenter/pipeline/result_sink.hpp"

namespace cleave::service {

// As segmentation::Segmenter::segment; used by one worker only.
using SegmentFunction = std::function<segmentation::Outcome(
    const segmentation::CloudView&, std::span<std::uint16_t>, segmentation::Segmentation&)>;

struct PipelineSettings {
  std::string sensor;
  Mode mode = Mode::live;
  std::size_t queue_capacity = 2;
  bool check_unit = true;  // reject clouds that seem to be in millimetres
};

class FramePipeline {
 public:
  // One worker thread a segment function: fewer than the sink has loans, so that there is one for a
  // frame that waits for a slower one before it. `sink` outlives this.
  FramePipeline(const PipelineSettings& settings, ResultSink& sink,
                std::vector<SegmentFunction> segmenters);
  ~FramePipeline() { drain(); }
  FramePipeline(const FramePipeline&) = delete;
  FramePipeline& operator=(const FramePipeline&) = delete;

  // From one thread. Live: returns at once. Lossless: waits while the queue is full. The cloud is
  // let go as soon as it is segmented.
  void accept(ReceivedCloud cloud);

  // Publishes all that was accepted, and ends the workers. No accept() after it.
  void drain();

  [[nodiscard]] FrameCounts counts() const { return ledger_.snapshot(); }
  [[nodiscard]] const LatencyWindow& latency() const { return latency_; }
  [[nodiscard]] std::string last_problem() const { return problems_.last(); }

 private:
  void answer_rejected(const FrameHeader& header, RejectCause cause);
  void enqueue(const FrameHeader& header, ReceivedCloud cloud);
  void work(const SegmentFunction& segment);
  void process(FrameQueue<Frame>::Taken taken, const SegmentFunction& segment);
  [[nodiscard]] std::optional<RejectCause> segment_into(FinishedFrame& finished, const Frame& frame,
                                                        const SegmentFunction& segment);
  [[nodiscard]] bool has_wrong_unit(const Frame& frame, const segmentation::CloudView& cloud);
  void drop(const Frame& frame, DropCause cause);
  void report(const Frame& frame, std::string_view fate, std::string_view why);
  // Once a doubt: a sensor whose clouds are sparse sends many of them.
  void advise(segmentation::Doubt doubt);
  void report_gap(const FrameHeader& header, std::uint64_t missed);

  const PipelineSettings settings_;
  ResultSink& sink_;
  FrameLedger ledger_;
  LatencyWindow latency_;
  ProblemLog problems_;
  LogLimiter gap_log_;
  LogLimiter frame_log_;
  struct Advice {
    std::atomic<bool> given{false};
    LogLimiter log;
  };
  std::array<Advice, segmentation::doubts> advice_;  // by Doubt
  ResultPublisher publisher_;
  InOrderPublisher<FinishedFrame> order_;
  FrameQueue<Frame> queue_;
  std::vector<SegmentFunction> segmenters_;
  std::vector<std::thread> workers_;
};

}  // namespace cleave::service
