// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/grabber/supervisor.hpp"

#include <utility>

namespace cleave::sensor {
namespace {

constexpr std::chrono::milliseconds status_interval(500);

}  // namespace

Supervisor::Supervisor(Stream& stream, const std::string& sensor, Fill fill)
    : publisher_(stream),
      fill_(std::move(fill)),
      report_(first_report(stream, grabber_node(sensor), sensor)),
      roudi_(stream) {
  publish();
}

void Supervisor::set_state(NodeState state) {
  if (std::exchange(report_.state, state) != state) publish();
}

void Supervisor::set_error(const std::string& error) {
  if (std::exchange(source_error_, error) != error) publish();
}

void Supervisor::set(NodeState state, const std::string& error) {
  report_.state = state;
  source_error_ = error;
  publish();
}

void Supervisor::update(Clock::time_point now) {
  if (roudi_.update(now) || now >= next_status_) publish();
}

void Supervisor::publish() {
  const auto now = Clock::now();
  next_status_ = now + status_interval;
  fill_(report_, now);
  report_.last_error = roudi_.error().empty() ? source_error_ : roudi_.error();
  publisher_.publish(report_);
}

}  // namespace cleave::sensor
