// The synthetic camera: a device with one depth sensor.
#pragma once

#include <string>

#include "sensor/driver/oni_driver_api.hpp"
#include "sensor/renderer/scene_uri.hpp"

namespace cleave::driver {

class Device : public oni::driver::DeviceBase {
 public:
  // `scene` as the device's name gives it; throws std::invalid_argument if that is no scene.
  Device(const std::string& scene, oni::driver::DriverServices& services);

  OniStatus getSensorInfoList(OniSensorInfo** sensors, int* count) override;
  oni::driver::StreamBase* createStream(OniSensorType type) override;
  void destroyStream(oni::driver::StreamBase* stream) override;
  OniBool isPropertySupported(int property) override;
  OniStatus getProperty(int property, void* data, int* size) override;

 private:
  std::string scene_;
  render::SceneRequest request_;
  oni::driver::DriverServices& services_;
  OniVideoMode mode_;
  OniSensorInfo depth_sensor_;
};

}  // namespace cleave::driver
