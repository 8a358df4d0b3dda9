// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/driver/depth_stream.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "sensor/renderer/view/camera.hpp"

namespace cleave::driver {
namespace {

constexpr int largest_depth_mm = 10000;

float field_of_view_rad(std::uint32_t pixels, double focal_length) {
  return static_cast<float>(2 * std::atan(pixels / (2 * focal_length)));
}

bool same_mode(const OniVideoMode& a, const OniVideoMode& b) {
  return a.pixelFormat == b.pixelFormat && a.resolutionX == b.resolutionX &&
         a.resolutionY == b.resolutionY && a.fps == b.fps;
}

}  // namespace

OniVideoMode video_mode(const render::SceneRequest& request) {
  return {ONI_PIXEL_FORMAT_DEPTH_1_MM, static_cast<int>(request.width),
          static_cast<int>(request.height), static_cast<int>(request.fps)};
}

DepthStream::DepthStream(const render::SceneRequest& request, oni::driver::DriverServices& services,
                         std::shared_ptr<FaultPlan> plan, std::function<void()> on_first_frame)
    : services_(services),
      camera_(render::camera_of_size(request.width, request.height)),
      mode_(video_mode(request)),
      plan_(std::move(plan)),
      on_first_frame_(std::move(on_first_frame)),
      mirrored_(request.mirrored),
      loop_(request, [this](const std::string& failure) {
        constexpr int error_severity = 3;
        services_.log(error_severity, __FILE__, __LINE__, "CleaveSynthetic", failure.c_str());
      }) {}

DepthStream::~DepthStream() {
  DepthStream::stop();
}

OniStatus DepthStream::start() {
  return guarded(services_, ONI_STATUS_ERROR, [this] {
    if (deliverer_.joinable()) return ONI_STATUS_OK;
    loop_.start();
    deliverer_ = std::jthread([this](const std::stop_token& stopped) { deliver(stopped); });
    return ONI_STATUS_OK;
  });
}

void DepthStream::stop() {
  deliverer_ = {};
  loop_.stop();
}

void DepthStream::deliver(const std::stop_token& stopped) {
  const std::chrono::nanoseconds period{std::chrono::nanoseconds(std::chrono::seconds(1)) /
                                        mode_.fps};
  Clock::time_point tick = Clock::now();
  int frame_index = 0;
  std::uint32_t shown = 0;
  while (!stopped.stop_requested()) {
    const bool rendered = loop_.ready() > 0;
    if (rendered && plan_->first_frame(tick)) on_first_frame_();
    const bool delivers = rendered && !plan_->silent(tick);
    if (delivers) {
      if (frame_index > 0) shown = loop_.after(shown);
      ++frame_index;
      if (!plan_->drops(tick)) send(loop_.frame(shown), frame_index, tick);
    }
    const Clock::time_point now = Clock::now();
    for (tick += period; tick < now; tick += period) {
      if (delivers) ++frame_index;
    }
    std::unique_lock lock(mutex_);
    pause_.wait_until(lock, stopped, tick, [] { return false; });
  }
}

void DepthStream::send(const std::vector<std::uint16_t>& depth_mm, int frame_index,
                       Clock::time_point tick) {
  OniFrame* const frame = getServices().acquireFrame();
  if (frame == nullptr) return;  // OpenNI2 has no buffer left: this frame is lost, as a camera's
  const std::size_t bytes = std::span(depth_mm).size_bytes();
  copy_image(depth_mm, static_cast<std::uint16_t*>(frame->data));
  frame->dataSize = static_cast<int>(bytes);
  frame->sensorType = ONI_SENSOR_DEPTH;
  frame->timestamp = timestamp_us(tick);
  frame->frameIndex = frame_index;
  frame->width = mode_.resolutionX;
  frame->height = mode_.resolutionY;
  frame->videoMode = mode_;
  frame->croppingEnabled = FALSE;
  frame->cropOriginX = 0;
  frame->cropOriginY = 0;
  frame->stride = mode_.resolutionX * static_cast<int>(sizeof(std::uint16_t));
  raiseNewFrame(frame);
  getServices().releaseFrame(frame);
}

void DepthStream::copy_image(const std::vector<std::uint16_t>& depth_mm,
                             std::uint16_t* image) const {
  std::ranges::copy(depth_mm, image);
  if (!mirrored_) return;
  for (int row = 0; row < mode_.resolutionY; ++row, image += mode_.resolutionX) {
    std::reverse(image, image + mode_.resolutionX);
  }
}

std::uint64_t DepthStream::timestamp_us(Clock::time_point tick) const {
  const Clock::time_point zero = std::max(created_, plan_->clock_reset(tick).value_or(created_));
  return static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::microseconds>(tick - zero).count());
}

OniBool DepthStream::isPropertySupported(int property) {
  switch (property) {
    case ONI_STREAM_PROPERTY_VIDEO_MODE:
    case ONI_STREAM_PROPERTY_HORIZONTAL_FOV:
    case ONI_STREAM_PROPERTY_VERTICAL_FOV:
    case ONI_STREAM_PROPERTY_MAX_VALUE:
    case ONI_STREAM_PROPERTY_MIN_VALUE:
    case ONI_STREAM_PROPERTY_STRIDE:
    case ONI_STREAM_PROPERTY_MIRRORING:
    case ONI_STREAM_PROPERTY_CROPPING:
      return TRUE;
    default:
      return FALSE;
  }
}

OniStatus DepthStream::getProperty(int property, void* data, int* size) {
  const render::Intrinsics& intrinsics = camera_.intrinsics;
  switch (property) {
    case ONI_STREAM_PROPERTY_VIDEO_MODE:
      return answer(mode_, data, size);
    case ONI_STREAM_PROPERTY_HORIZONTAL_FOV:
      return answer(field_of_view_rad(camera_.width, intrinsics.fx), data, size);
    case ONI_STREAM_PROPERTY_VERTICAL_FOV:
      return answer(field_of_view_rad(camera_.height, intrinsics.fy), data, size);
    case ONI_STREAM_PROPERTY_MAX_VALUE:
      return answer(largest_depth_mm, data, size);
    case ONI_STREAM_PROPERTY_MIN_VALUE:
      return answer(0, data, size);
    case ONI_STREAM_PROPERTY_STRIDE:
      return answer(mode_.resolutionX * static_cast<int>(sizeof(std::uint16_t)), data, size);
    case ONI_STREAM_PROPERTY_MIRRORING:
      return answer(OniBool{mirrored_ ? TRUE : FALSE}, data, size);
    case ONI_STREAM_PROPERTY_CROPPING:
      // Without an answer OpenNI2 makes recordings of the stream that do not play.
      return answer(OniCropping{FALSE, 0, 0, mode_.resolutionX, mode_.resolutionY}, data, size);
    default:
      return ONI_STATUS_NOT_SUPPORTED;
  }
}

// All but mirroring is as it is: asking for that is fine, asking for something else is refused.
OniStatus DepthStream::setProperty(int property, const void* data, int size) {
  const auto asks_for = [data, size]<class T>(T& value) {
    if (size != static_cast<int>(sizeof(T))) return false;
    std::memcpy(&value, data, sizeof(T));
    return true;
  };
  OniVideoMode mode{};
  OniBool mirrored = FALSE;
  OniCropping cropping{};
  bool as_it_is = false;
  if (property == ONI_STREAM_PROPERTY_VIDEO_MODE) {
    as_it_is = asks_for(mode) && same_mode(mode, mode_);
  } else if (property == ONI_STREAM_PROPERTY_MIRRORING) {
    as_it_is = asks_for(mirrored);
    if (as_it_is) mirrored_ = mirrored != FALSE;
  } else if (property == ONI_STREAM_PROPERTY_CROPPING) {
    as_it_is = asks_for(cropping) && cropping.enabled == FALSE;
  }
  return as_it_is ? ONI_STATUS_OK : ONI_STATUS_NOT_SUPPORTED;
}

}  // namespace cleave::driver
