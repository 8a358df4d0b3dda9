// SPDX-License-Identifier: BSD-3-Clause
// Renders the synthetic camera's loop of frames in the background, while frames are delivered.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "sensor/renderer/scene/scene_loop.hpp"

namespace cleave::driver {

class RenderedLoop {
 public:
  // `report_failure` is called, by the rendering thread, if a frame cannot be rendered; the loop
  // then keeps the frames that it has.
  RenderedLoop(const render::SceneRequest& request,
               std::function<void(const std::string&)> report_failure);

  // Throws std::system_error if no thread can be started.
  void start();
  // Returns once the frame that is being rendered is done; start() goes on with the next.
  void stop();

  // Frames 0 to ready() - 1 are there and never change any more. From any thread.
  [[nodiscard]] std::uint32_t ready() const { return ready_.load(std::memory_order_acquire); }
  // Depths of the requested size in millimetres, row-major. `index` below ready().
  [[nodiscard]] const std::vector<std::uint16_t>& frame(std::uint32_t index) const {
    return frames_[index];
  }
  // The frame to show after `index`: the same again as long as the next one is not rendered.
  [[nodiscard]] std::uint32_t after(std::uint32_t index) const;

 private:
  void render(const std::stop_token& stopped);

  render::SceneLoop scene_;
  std::function<void(const std::string&)> report_failure_;
  std::vector<std::vector<std::uint16_t>> frames_;  // those from ready_ on are the renderer's alone
  std::atomic<std::uint32_t> ready_ = 0;
  std::jthread renderer_;  // last, so that it ends before what it uses
};

}  // namespace cleave::driver
