// SPDX-License-Identifier: BSD-3-Clause
// The plug-in's entry: which devices there are. Every `synthetic:SCENE` is one, once asked for.
#include <algorithm>
#include <condition_variable>
#include <cstdlib>
#include <list>
#include <memory>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>

#include "sensor/driver/device.hpp"
#include "sensor/driver/fault_plan.hpp"
#include "sensor/driver/oni_driver_api.hpp"
#include "sensor/renderer/scene/scene_uri.hpp"

namespace cleave::driver {
namespace {

constexpr std::string_view prefix = "synthetic:";

void set_text(char (&field)[ONI_MAX_STR], std::string_view text) {
  if (text.size() >= ONI_MAX_STR) {
    throw std::invalid_argument("the device's name has " + std::to_string(text.size()) +
                                " characters, OpenNI2 takes " + std::to_string(ONI_MAX_STR - 1));
  }
  text.copy(field, text.size());
}

// A camera that has a name: announced, opened, unplugged by it.
struct Camera {
  OniDeviceInfo info{};
  std::shared_ptr<FaultPlan> plan;
};

class SyntheticDriver : public oni::driver::DriverBase {
 public:
  explicit SyntheticDriver(OniDriverServices* services) : DriverBase(services) {}

  // CLEAVE_SYNTHETIC holds SCENEs, parted by blanks, that are there from the start.
  OniStatus initialize(oni::driver::DeviceConnectedCallback connected,
                       oni::driver::DeviceDisconnectedCallback disconnected,
                       oni::driver::DeviceStateChangedCallback state_changed,
                       void* cookie) override {
    const OniStatus status = DriverBase::initialize(connected, disconnected, state_changed, cookie);
    const char* const scenes = std::getenv("CLEAVE_SYNTHETIC");
    std::istringstream names(scenes == nullptr ? "" : scenes);
    for (std::string scene; status == ONI_STATUS_OK && names >> scene;) {
      static_cast<void>(announce(std::string(prefix) + scene));
    }
    return status;
  }

  // OpenNI2 asks this about names that no driver has announced.
  OniStatus tryDevice(const char* uri) override {
    const std::string_view name(uri);
    return name.starts_with(prefix) ? announce(name) : ONI_STATUS_ERROR;
  }

  oni::driver::DeviceBase* deviceOpen(const char* uri, const char* /*mode*/) override {
    return guarded<oni::driver::DeviceBase*>(getServices(), nullptr, [this, uri] {
      Camera& camera = named(uri);
      const auto now = FaultPlan::Clock::now();
      if (camera.plan->unplugged(now)) throw std::runtime_error("the camera is unplugged");
      if (camera.plan->in_use(now)) throw std::runtime_error("the camera is in use");
      return new Device(std::string(uri).substr(prefix.size()), getServices(), camera.plan,
                        [this, &camera] { play_absence(camera); });
    });
  }

  void deviceClose(oni::driver::DeviceBase* device) override { delete device; }

  void shutdown() override {}

 private:
  OniStatus announce(std::string_view name) {
    return guarded(getServices(), ONI_STATUS_ERROR, [this, name] {
      const render::SceneRequest request = render::parse_scene(name.substr(prefix.size()));
      Camera camera;
      set_text(camera.info.uri, name);
      set_text(camera.info.vendor, "Cleave");
      set_text(camera.info.name, "Synthetic camera");
      camera.plan =
          std::make_shared<FaultPlan>(request.faults, request.fps, FaultPlan::Clock::now());
      cameras_.push_back(camera);
      deviceConnected(&cameras_.back().info);
      return ONI_STATUS_OK;
    });
  }

  Camera& named(std::string_view uri) {
    const auto found =
        std::ranges::find_if(cameras_, [uri](const Camera& c) { return c.info.uri == uri; });
    if (found == cameras_.end()) throw std::logic_error("no camera was announced by this name");
    return *found;
  }

  // A thread of its own tells OpenNI2: its listeners must not hold up the delivery of frames, for
  // whose end a listener that closes the camera would wait.
  void play_absence(Camera& camera) {
    const auto absence = camera.plan->absence();
    if (!absence) return;
    const std::lock_guard lock_list(mutex_);
    absences_.emplace_back([this, &camera, absence](const std::stop_token& stopped) {
      std::mutex mutex;
      std::unique_lock lock(mutex);
      std::condition_variable_any pause;
      pause.wait_until(lock, stopped, absence->from, [] { return false; });
      if (stopped.stop_requested()) return;
      deviceDisconnected(&camera.info);
      pause.wait_until(lock, stopped, absence->to, [] { return false; });
      if (!stopped.stop_requested()) deviceConnected(&camera.info);
    });
  }

  std::mutex mutex_;                  // guards absences_
  std::list<Camera> cameras_;         // OpenNI2 keeps pointers to their infos
  std::list<std::jthread> absences_;  // last: they use the cameras
};

}  // namespace
}  // namespace cleave::driver

ONI_EXPORT_DRIVER(cleave::driver::SyntheticDriver)
