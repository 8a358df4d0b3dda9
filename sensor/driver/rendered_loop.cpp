// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/driver/rendered_loop.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <exception>
#include <utility>

namespace cleave::driver {
namespace {

// A camera costs its machine nothing: rendering must not take cores from whoever uses the frames
// that are there. Threads have a nice value of their own on Linux; failing costs only that
// courtesy.
void give_way_to_other_threads() {
  constexpr int nice = 10;
  (void)::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), nice);
}

}  // namespace

RenderedLoop::RenderedLoop(const render::SceneRequest& request,
                           std::function<void(const std::string&)> report_failure)
    : scene_(request), report_failure_(std::move(report_failure)), frames_(scene_.size()) {}

void RenderedLoop::start() {
  if (renderer_.joinable()) return;
  renderer_ = std::jthread([this](const std::stop_token& stopped) { render(stopped); });
}

void RenderedLoop::stop() {
  renderer_ = {};
}

std::uint32_t RenderedLoop::after(std::uint32_t index) const {
  const auto next = static_cast<std::uint32_t>((index + 1) % frames_.size());
  return next < ready() ? next : index;
}

void RenderedLoop::render(const std::stop_token& stopped) {
  give_way_to_other_threads();
  try {
    for (std::uint32_t i = ready(); i < frames_.size() && !stopped.stop_requested(); ++i) {
      frames_[i] = scene_.frame(i).depth_mm;
      ready_.store(i + 1, std::memory_order_release);
    }
  } catch (const std::exception& error) {
    report_failure_(std::string("cannot render the synthetic camera's next frame: ") +
                    error.what());
  }
}

}  // namespace cleave::driver
