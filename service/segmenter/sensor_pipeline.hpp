// SPDX-License-Identifier: BSD-3-Clause
// One sensor in the daemon: its cloud reader, the pipeline, its result writers, and what the status
// says of them.
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "libcleave/cloud_reader.hpp"
#include "libcleave/status.hpp"
#include "libcleave/stream.hpp"
#include "libcleave/types.hpp"
#include "libcleave/wait_set.hpp"
#include "segmenter/dds_sink.hpp"
#include "segmenter/pipeline/frame_pipeline.hpp"
#include "segmenter/source_watch.hpp"

namespace cleave::service {

class SensorPipeline {
 public:
  // Reads from construction on. Throws std::runtime_error. `stream` outlives this.
  SensorPipeline(Stream& stream, const PipelineSettings& settings,
                 std::vector<SegmentFunction> segmenters);
  ~SensorPipeline() {
    stop_taking();
    drain();
  }
  SensorPipeline(const SensorPipeline&) = delete;
  SensorPipeline& operator=(const SensorPipeline&) = delete;

  // Takes no more clouds; the state is stopping.
  void stop_taking();
  // Publishes the results of all clouds that were taken. After stop_taking().
  void drain() { pipeline_.drain(); }

  // Looks whether the source is alive; true, and said in the log, if that changed the state. From
  // one thread, as report().
  bool update_state();
  [[nodiscard]] NodeReport report() const;

 private:
  void take_clouds();

  Stream& stream_;
  const std::string sensor_;
  DdsSink sink_;
  CloudReader clouds_;
  FramePipeline pipeline_;  // after the reader whose samples it holds
  WaitSet wait_set_;
  SourceWatch source_;
  std::atomic<bool> stopping_{false};
  std::thread taking_;
};

}  // namespace cleave::service
