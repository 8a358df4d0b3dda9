// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/grabber/supervisor.hpp"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <utility>

namespace cleave::sensor {
namespace {

constexpr std::chrono::milliseconds status_interval(500);
constexpr std::chrono::seconds roudi_interval(1);

}  // namespace

Supervisor::Supervisor(Stream& stream, const std::string& sensor, Fill fill)
    : publisher_(stream), fill_(std::move(fill)) {
  report_.node = "grabber/" + sensor;
  report_.version = CLEAVE_VERSION;
  report_.sensor = sensor;
  report_.process_id = static_cast<std::uint32_t>(::getpid());
  report_.transport_in_force = stream.transport();
  report_.transport_reason = stream.transport_reason();
  if (stream.transport() == Transport::shared_memory) roudi_.emplace();
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
  if (roudi_ && now >= next_check_) {
    next_check_ = now + roudi_interval;
    check_roudi();
  }
  if (now >= next_status_) publish();
}

void Supervisor::publish() {
  const auto now = Clock::now();
  next_status_ = now + status_interval;
  fill_(report_, now);
  report_.last_error = roudi_error_.empty() ? source_error_ : roudi_error_;
  publisher_.publish(report_);
}

void Supervisor::check_roudi() {
  switch (roudi_->check()) {
    case RouDiState::present:
      if (!std::exchange(roudi_error_, "").empty()) publish();
      break;
    case RouDiState::gone:
      if (!roudi_error_.empty()) return;
      roudi_error_ = "RouDi is gone: who is connected goes on, nobody new can join; start it again";
      spdlog::warn("{}", roudi_error_);
      publish();
      break;
    case RouDiState::replaced:
      roudi_replaced_ = true;
      break;
  }
}

}  // namespace cleave::sensor
