// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/replay/replay_session.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <utility>

#include "recording/error.hpp"
#include "recording/time_units.hpp"

namespace cleave::client {
namespace {

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;

constexpr auto replay_tick = 50ms;
constexpr auto retry = 1ms;  // until a reader gives a chunk of shared memory back
// A reader that has just been found needs a moment for its other topics.
constexpr auto replay_settling_time = 500ms;
constexpr auto last_frames_time = 1s;

}  // namespace

ReplaySession::ReplaySession(Stream& stream, ReplayPlan plan)
    : stream_(stream),
      plan_(std::move(plan)),
      reader_(plan_.file, plan_.selection, plan_.loop),
      clock_(plan_.rate, recording::GapLimit(plan_.max_gap_s)) {}

void ReplaySession::run(Shutdown& shutdown, const std::function<void()>& on_tick) {
  recording::AheadFrame ahead;
  while (!shutdown.requested()) {
    const auto result = reader_.next(replay_tick, ahead);
    if (result == recording::ReadAhead::Result::end) break;
    if (result == recording::ReadAhead::Result::item) publish(ahead, shutdown, on_tick);
    update();
    on_tick();
  }
  linger(shutdown);
}

void ReplaySession::publish(const recording::AheadFrame& ahead, Shutdown& shutdown,
                            const std::function<void()>& on_tick) {
  const std::size_t known_sensors = sensors_.size();
  SensorReplay& sensor = sensor_of(ahead.frame);
  if (sensors_.size() > known_sensors) wait_for_readers(sensor, shutdown, on_tick);
  wait_until_due(ahead, shutdown, on_tick);
  try {
    while (!shutdown.requested()) {
      if (sensor.ready() && sensor.publish(ahead.frame, ahead.pass)) return note(ahead);
      (void)shutdown.wait_for(retry);
      update();
      on_tick();
    }
  } catch (const recording::DataError& error) {
    spdlog::warn("not replayed: {}", error.what());
  }
}

void ReplaySession::wait_until_due(const recording::AheadFrame& ahead, Shutdown& shutdown,
                                   const std::function<void()>& on_tick) {
  while (!shutdown.requested()) {
    const auto left = clock_.until_due(ahead.frame.log_time_ns, ahead.pass, Clock::now());
    if (const auto jump = clock_.new_jump()) spdlog::warn("{}", *jump);
    if (left <= Clock::duration::zero()) return;
    (void)shutdown.wait_for(std::min(std::chrono::ceil<std::chrono::milliseconds>(left),
                                     std::chrono::milliseconds(replay_tick)));
    update();
    on_tick();
  }
}

SensorReplay& ReplaySession::sensor_of(const recording::Frame& frame) {
  const std::string& name = frame.header().sensor;
  const auto [entry, is_new] =
      sensors_.try_emplace(name, stream_, name, plan_.selection.kinds, plan_.window);
  if (is_new) spdlog::info("waiting for a reader of sensor '{}'", name);
  return entry->second;
}

// Before a sensor's first frame only: a reader that leaves later may come back.
void ReplaySession::wait_for_readers(const SensorReplay& sensor, Shutdown& shutdown,
                                     const std::function<void()>& on_tick) {
  auto settled = Clock::time_point::max();
  while (!shutdown.requested() && Clock::now() < settled) {
    if (!sensor.has_readers()) settled = Clock::time_point::max();
    if (sensor.has_readers()) settled = std::min(settled, Clock::now() + replay_settling_time);
    (void)shutdown.wait_for(replay_tick);
    update();
    on_tick();
  }
}

void ReplaySession::note(const recording::AheadFrame& ahead) {
  const std::int64_t log_ns = ahead.frame.log_time_ns;
  if (!first_log_ns_) first_log_ns_ = log_ns;
  position_s_ = recording::seconds_between(*first_log_ns_, log_ns);
  ++published_[ahead.frame.kind()];
  ended_ = Clock::now();
  if (!began_) began_ = ended_;
}

double ReplaySession::mean_rate_hz() const {
  if (!began_ || ended_ == *began_) return 0;
  std::uint64_t most = 0;
  for (const auto& [kind, count] : published_) most = std::max(most, count);
  return static_cast<double>(most - 1) / std::chrono::duration<double>(ended_ - *began_).count();
}

void ReplaySession::update() {
  for (auto& [name, sensor] : sensors_) sensor.update();
}

void ReplaySession::linger(Shutdown& shutdown) {
  for (auto& [name, sensor] : sensors_) sensor.set_state(NodeState::ended);
  const auto end = Clock::now() + last_frames_time;
  const auto in_flight = [this] {
    return std::ranges::any_of(sensors_, [](const auto& s) { return s.second.in_flight() > 0; });
  };
  while (!shutdown.requested() && (Clock::now() < end || in_flight())) {
    (void)shutdown.wait_for(replay_tick);
    update();
  }
}

}  // namespace cleave::client
