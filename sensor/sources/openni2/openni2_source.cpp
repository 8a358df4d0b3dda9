// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/sources/openni2/openni2_source.hpp"

#include <OpenNI.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <mutex>
#include <utility>

#include "libcleave/types.hpp"
#include "recording/cloud/depth_to_points.hpp"
#include "sensor/sources/capture_clock.hpp"
#include "sensor/sources/openni2/openni2_device.hpp"
#include "sensor/sources/openni2/openni2_library.hpp"
#include "sensor/sources/openni2/openni2_mode.hpp"

namespace cleave::sensor {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds max_start(5000);  // until the first frame

// OpenNI2 tells on a thread of the driver's that a device was unplugged.
class Disconnection : public openni::OpenNI::DeviceDisconnectedListener {
 public:
  Disconnection() { openni::OpenNI::addDeviceDisconnectedListener(this); }
  ~Disconnection() override { openni::OpenNI::removeDeviceDisconnectedListener(this); }
  Disconnection(const Disconnection&) = delete;
  Disconnection& operator=(const Disconnection&) = delete;

  void watch(const std::string& uri) {
    const std::lock_guard lock(mutex_);
    uri_ = uri;
    happened_ = false;
  }
  [[nodiscard]] bool happened() const {
    const std::lock_guard lock(mutex_);
    return happened_;
  }

 private:
  void onDeviceDisconnected(const openni::DeviceInfo* device) override {
    const std::lock_guard lock(mutex_);
    if (uri_ == device->getUri()) happened_ = true;
  }
  mutable std::mutex mutex_;  // guards the two below
  std::string uri_;
  bool happened_ = false;
};

}  // namespace

struct OpenNi2Source::State {
  State(std::string u, const VideoMode& m)
      : uri(std::move(u)),
        mode(m),
        max_silence(std::max(milliseconds(800), milliseconds(3000 / std::max(1U, m.fps)))) {}

  Failure open_stream();
  Failure prepare_stream();
  void close();
  Poll read(Frame& frame);
  Poll lose(const std::string& why) {
    error = why;
    return Poll::lost;
  }

  std::string uri;
  VideoMode mode;
  milliseconds max_silence;  // between frames
  milliseconds silence{0};   // time waited since the last frame
  std::unique_ptr<Disconnection> disconnection;
  openni::Device device;
  openni::VideoStream stream;
  openni::VideoFrameRef held;
  Intrinsics intrinsics;
  recording::DepthProjection projection;
  CaptureClock clock;
  std::optional<int> last_index;
  std::uint64_t sensor_drops = 0;
  std::string error;
  bool in_use = false;
};

Failure OpenNi2Source::State::open_stream() {
  const OpenResult opened = open_device(device, uri);
  in_use = opened.in_use;
  if (opened.failure) return opened.failure;
  disconnection->watch(device.getDeviceInfo().getUri());
  if (stream.create(device, openni::SENSOR_DEPTH) != openni::STATUS_OK) {
    return "the device has no depth stream: " + openni2_error();
  }
  return prepare_stream();
}

Failure OpenNi2Source::State::prepare_stream() {
  if (Failure failure = set_mode(stream, mode)) return failure;
  if (Failure failure = set_registration(device, mode.registration)) return failure;
  if (Failure failure = set_mirroring(stream, mode.mirror)) return failure;
  intrinsics = recording::intrinsics_from_fov(
      mode.width, mode.height, stream.getHorizontalFieldOfView(), stream.getVerticalFieldOfView());
  if (intrinsics.fx == 0) return "the camera does not tell its field of view";
  projection = recording::DepthProjection(mode.width, mode.height, intrinsics);
  if (stream.start() == openni::STATUS_OK) return std::nullopt;
  return "the depth stream does not start: " + openni2_error();
}

void OpenNi2Source::State::close() {
  held.release();
  if (stream.isValid()) {
    stream.stop();
    stream.destroy();
  }
  if (device.isValid()) device.close();
}

Poll OpenNi2Source::State::read(Frame& frame) {
  if (stream.readFrame(&held) != openni::STATUS_OK || !held.isValid()) {
    return lose("the camera gave no frame: " + openni2_error());
  }
  const std::int64_t arrival_ns = monotonic_now_ns();
  if (held.getWidth() != static_cast<int>(mode.width) ||
      held.getHeight() != static_cast<int>(mode.height) ||
      !is_depth(held.getVideoMode().getPixelFormat())) {
    return lose("the camera left the depth mode that it was set to");
  }
  const CaptureClock::Stamp stamp = clock.stamp(held.getTimestamp(), arrival_ns);
  const int index = held.getFrameIndex();
  // A device that began anew counts from the start again.
  if (last_index && index > *last_index + 1) {
    sensor_drops += static_cast<std::uint64_t>(index - *last_index - 1);
  }
  last_index = index;
  silence = milliseconds(0);
  frame = {mode.width,          mode.height, intrinsics, wall_now_ns() - stamp.delay_ns,
           held.getTimestamp(), stamp.reset};
  return Poll::frame;
}

OpenNi2Source::OpenNi2Source(std::string uri, const VideoMode& mode)
    : state_(std::make_unique<State>(std::move(uri), mode)) {}

OpenNi2Source::~OpenNi2Source() {
  state_->close();
}

Failure OpenNi2Source::open() {
  State& s = *state_;
  if (Failure failure = initialise_openni2()) return failure;
  if (!s.disconnection) s.disconnection = std::make_unique<Disconnection>();
  s.close();
  s.clock.restart();
  s.last_index.reset();
  s.silence = milliseconds(0);
  Failure failure = s.open_stream();
  if (failure) {
    s.error = *failure;
    s.close();
  } else {
    spdlog::info("opened {} {}: {}", s.device.getDeviceInfo().getVendor(),
                 s.device.getDeviceInfo().getName(), describe(s.stream.getVideoMode()));
  }
  return failure;
}

Poll OpenNi2Source::next(milliseconds timeout, Frame& frame) {
  State& s = *state_;
  if (s.disconnection->happened()) return s.lose("the camera was disconnected");
  s.held.release();
  openni::VideoStream* streams[] = {&s.stream};
  int ready = 0;
  const openni::Status status =
      openni::OpenNI::waitForAnyStream(streams, 1, &ready, static_cast<int>(timeout.count()));
  if (status == openni::STATUS_OK) return s.read(frame);
  if (status != openni::STATUS_TIME_OUT) {
    return s.lose("waiting for the camera failed: " + openni2_error());
  }
  s.silence += timeout;
  if (s.silence < (s.last_index ? s.max_silence : max_start)) return Poll::timeout;
  return s.lose("the camera sent no frame for " + std::to_string(s.silence.count()) + " ms");
}

void OpenNi2Source::write_points(float* xyz) {
  const State& s = *state_;
  const bool millimetres =
      s.held.getVideoMode().getPixelFormat() == openni::PIXEL_FORMAT_DEPTH_1_MM;
  const recording::DepthRows image{
      static_cast<const std::uint16_t*>(s.held.getData()), s.mode.width, s.mode.height,
      static_cast<std::size_t>(s.held.getStrideInBytes()), millimetres ? 1e-3F : 1e-4F};
  s.projection.write_points(image, xyz);
}

SourceCounts OpenNi2Source::counts() const {
  return {state_->sensor_drops, {}};
}

std::string OpenNi2Source::last_error() const {
  return state_->error;
}

bool OpenNi2Source::in_use() const {
  return state_->in_use;
}

}  // namespace cleave::sensor
