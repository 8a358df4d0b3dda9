// SPDX-License-Identifier: BSD-3-Clause
#include "segmenter/daemon.hpp"

#include <spdlog/spdlog.h>

#include "segmenter/warm_segmenter.hpp"

namespace cleave::service {
namespace {

constexpr std::chrono::milliseconds tick(100);  // how soon a change of state is seen
constexpr std::chrono::milliseconds status_interval(500);
constexpr std::chrono::seconds roudi_interval(1);

}  // namespace

Daemon::Daemon(const DaemonSettings& settings) : stream_(settings.stream), status_(stream_) {
  if (stream_.transport() == Transport::shared_memory) roudi_.emplace();
  for (const std::string& sensor : settings.sensors) start(settings, sensor);
  publish_due_status();
}

void Daemon::start(const DaemonSettings& settings, const std::string& sensor) {
  pipelines_.push_back(std::make_unique<SensorPipeline>(
      stream_,
      PipelineSettings{sensor, settings.mode, settings.queue_capacity, settings.check_unit},
      warm_segmenters(settings.segmentation, settings.workers)));
  spdlog::info("ready: segmenting sensor '{}' with {} worker{}, {} ({})", sensor, settings.workers,
               settings.workers == 1 ? "" : "s", to_string(stream_.transport()),
               stream_.transport_reason());
}

Ending Daemon::run(Shutdown& shutdown) {
  Ending ending = Ending::asked;
  while (!shutdown.wait_for(tick)) {
    if (roudi_replaced()) {
      ending = Ending::roudi_replaced;
      break;
    }
    publish_due_status();
  }
  drain();
  return ending;
}

bool Daemon::roudi_replaced() {
  if (!roudi_ || Clock::now() < next_roudi_check_) return false;
  next_roudi_check_ = Clock::now() + roudi_interval;
  switch (roudi_->check()) {
    case RouDiState::present:
      return false;
    case RouDiState::gone:
      if (roudi_error_.empty()) {
        roudi_error_ =
            "RouDi is gone: who is connected goes on, nobody new can join; start it again";
        spdlog::warn("{}", roudi_error_);
      }
      return false;
    case RouDiState::replaced:
      break;
  }
  spdlog::warn("another RouDi runs: restarting in place to join it");
  return true;
}

// All of them every half second, and each as soon as its state changes.
void Daemon::publish_due_status() {
  const bool due = Clock::now() >= next_status_;
  if (due) next_status_ = Clock::now() + status_interval;
  for (const auto& pipeline : pipelines_) {
    const bool changed = pipeline->update_state();
    if (due || changed) publish_status(*pipeline);
  }
}

void Daemon::publish_status(const SensorPipeline& pipeline) {
  NodeReport report = pipeline.report();
  if (!roudi_error_.empty()) report.last_error = roudi_error_;
  status_.publish(report);
}

void Daemon::drain() {
  for (const auto& pipeline : pipelines_) {
    pipeline->stop_taking();
    publish_status(*pipeline);
  }
  for (const auto& pipeline : pipelines_) {
    pipeline->drain();
    publish_status(*pipeline);
    const NodeReport report = pipeline->report();
    spdlog::info("stopped sensor '{}': {} frames received, {} published, {} dropped, {} rejected",
                 report.sensor, report.frames_in, report.frames_out, report.frames_dropped,
                 report.frames_rejected);
  }
}

}  // namespace cleave::service
