// The plug-in's entry: which devices there are. Every `synthetic:SCENE` is one, once asked for.
#include <list>
#include <stdexcept>
#include <string>
#include <string_view>

#include "sensor/driver/device.hpp"
#include "sensor/driver/oni_driver_api.hpp"
#include "sensor/renderer/scene_uri.hpp"

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

class SyntheticDriver : public oni::driver::DriverBase {
 public:
  explicit SyntheticDriver(OniDriverServices* services) : DriverBase(services) {}

  // OpenNI2 asks this about names that no driver has announced.
  OniStatus tryDevice(const char* uri) override {
    const std::string_view name(uri);
    if (!name.starts_with(prefix)) return ONI_STATUS_ERROR;
    return guarded(getServices(), ONI_STATUS_ERROR, [this, name] {
      static_cast<void>(render::parse_scene(name.substr(prefix.size())));
      OniDeviceInfo info{};
      set_text(info.uri, name);
      set_text(info.vendor, "Cleave");
      set_text(info.name, "Synthetic camera");
      announced_.push_back(info);
      deviceConnected(&announced_.back());
      return ONI_STATUS_OK;
    });
  }

  oni::driver::DeviceBase* deviceOpen(const char* uri, const char* /*mode*/) override {
    return guarded<oni::driver::DeviceBase*>(getServices(), nullptr, [this, uri] {
      return new Device(std::string(uri).substr(prefix.size()), getServices());
    });
  }

  void deviceClose(oni::driver::DeviceBase* device) override { delete device; }

  void shutdown() override {}

 private:
  std::list<OniDeviceInfo> announced_;  // OpenNI2 keeps pointers to them
};

}  // namespace
}  // namespace cleave::driver

ONI_EXPORT_DRIVER(cleave::driver::SyntheticDriver)
