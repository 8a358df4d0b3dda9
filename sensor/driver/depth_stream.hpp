// SPDX-License-Identifier: BSD-3-Clause
// The synthetic camera's depth stream.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "sensor/driver/fault_plan.hpp"
#include "sensor/driver/oni_driver_api.hpp"
#include "sensor/driver/rendered_loop.hpp"
#include "sensor/renderer/scene/scene_uri.hpp"
#include "sensor/renderer/view/camera.hpp"

namespace cleave::driver {

// The only one that the camera has.
[[nodiscard]] OniVideoMode video_mode(const render::SceneRequest& request);

// One thread delivers a frame at each tick of the mode's rate; ticks are absolute, so that the rate
// does not drift. Ticks that the machine missed are numbered and left out, as a camera's frames are
// that nobody takes. Time stamps are the ticks' times in microseconds since the stream was created,
// or since its clock was reset. The plan says which frames do not come.
class DepthStream : public oni::driver::StreamBase {
 public:
  // `on_first_frame` is called when the plan's clock begins, on the thread that delivers frames.
  DepthStream(const render::SceneRequest& request, oni::driver::DriverServices& services,
              std::shared_ptr<FaultPlan> plan, std::function<void()> on_first_frame);
  ~DepthStream() override;
  DepthStream(const DepthStream&) = delete;
  DepthStream& operator=(const DepthStream&) = delete;

  OniStatus start() override;
  void stop() override;
  OniBool isPropertySupported(int property) override;
  OniStatus getProperty(int property, void* data, int* size) override;
  OniStatus setProperty(int property, const void* data, int size) override;

 private:
  using Clock = std::chrono::steady_clock;

  void deliver(const std::stop_token& stopped);
  void send(const std::vector<std::uint16_t>& depth_mm, int frame_index, Clock::time_point tick);
  void copy_image(const std::vector<std::uint16_t>& depth_mm, std::uint16_t* image) const;
  [[nodiscard]] std::uint64_t timestamp_us(Clock::time_point tick) const;

  oni::driver::DriverServices& services_;
  const render::CameraModel camera_;
  OniVideoMode mode_;
  Clock::time_point created_ = Clock::now();
  std::shared_ptr<FaultPlan> plan_;
  std::function<void()> on_first_frame_;
  std::atomic<bool> mirrored_;
  RenderedLoop loop_;
  std::mutex mutex_;  // guards nothing: the pause between ticks waits on it
  std::condition_variable_any pause_;
  std::jthread deliverer_;
};

}  // namespace cleave::driver
