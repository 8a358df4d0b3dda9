// SPDX-License-Identifier: BSD-3-Clause
#include "segmenter/daemon.hpp"

#include <spdlog/spdlog.h>

#include "segmenter/warm_segmenter.hpp"

namespace cleave::service {
namespace {

constexpr std::chrono::milliseconds tick(100);  // how soon a change of state is seen
constexpr std::chrono::milliseconds status_interval(500);

}  // namespace

Daemon::Daemon(const DaemonSettings& settings, const Shutdown& shutdown)
    : stream_(settings.stream), status_(stream_), roudi_(stream_) {
  for (const std::string& sensor : settings.sensors) {
    if (shutdown.requested()) return;
    start(settings, sensor);
  }
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
  while (!shutdown.wait_for(tick)) {
    publish_due_status();
    if (roudi_.restart_joins()) break;
  }
  drain();
  const bool anew = roudi_.restart_joins() || shutdown.roudi() != 0;
  return anew ? Ending::start_anew : Ending::asked;
}

// All of them every half second and when RouDi goes or comes, and each as soon as its state
// changes.
void Daemon::publish_due_status() {
  const auto now = Clock::now();
  const bool due = roudi_.update(now) || now >= next_status_;
  if (due) next_status_ = now + status_interval;
  for (const auto& pipeline : pipelines_) {
    const bool changed = pipeline->update_state();
    if (due || changed) publish_status(*pipeline);
  }
}

void Daemon::publish_status(const SensorPipeline& pipeline) {
  NodeReport report = pipeline.report();
  if (!roudi_.error().empty()) report.last_error = roudi_.error();
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
