// SPDX-License-Identifier: BSD-3-Clause
// The segmenter as a node of the stream: one pipeline a sensor, their status, and RouDi's health.
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "libcleave/process/shutdown.hpp"
#include "libcleave/roudi.hpp"
#include "libcleave/status.hpp"
#include "libcleave/stream.hpp"
#include "segmentation/options.hpp"
#include "segmenter/pipeline/frame_queue.hpp"
#include "segmenter/sensor_pipeline.hpp"

namespace cleave::service {

struct DaemonSettings {
  StreamOptions stream;
  std::vector<std::string> sensors;
  std::size_t workers = 1;  // a sensor
  std::size_t queue_capacity = 2;
  bool check_unit = true;
  Mode mode = Mode::live;
  segmentation::Options segmentation;
};

enum class Ending {
  asked,      // by a signal
  start_anew  // only a fresh process joins the RouDi that is there now, or survives the one that
              // ends
};

class Daemon {
 public:
  // Ready, and said so, when it returns; earlier when shutdown is requested. Throws
  // std::runtime_error, or std::invalid_argument for a wrong option of the segmentation.
  Daemon(const DaemonSettings& settings, const Shutdown& shutdown);

  // Until shutdown is requested or the program must start anew; drains before it returns.
  [[nodiscard]] Ending run(Shutdown& shutdown);

 private:
  using Clock = std::chrono::steady_clock;
  void start(const DaemonSettings& settings, const std::string& sensor);
  void publish_status(const SensorPipeline& pipeline);
  void publish_due_status();
  void drain();

  Stream stream_;
  StatusPublisher status_;
  RouDiWatch roudi_;
  Clock::time_point next_status_{};
  std::vector<std::unique_ptr<SensorPipeline>> pipelines_;
};

}  // namespace cleave::service
