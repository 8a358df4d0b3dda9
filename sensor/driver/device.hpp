// SPDX-License-Identifier: BSD-3-Clause
// The synthetic camera: a device with one depth sensor.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "sensor/driver/fault_plan.hpp"
#include "sensor/driver/oni_driver_api.hpp"
#include "sensor/renderer/scene/scene_uri.hpp"

namespace cleave::driver {

class Device : public oni::driver::DeviceBase {
 public:
  // `scene` as the device's name gives it; throws std::invalid_argument if that is no scene.
  // `on_first_frame` is called when the plan's clock begins, on the thread that delivers frames.
  Device(const std::string& scene, oni::driver::DriverServices& services,
         std::shared_ptr<FaultPlan> plan, std::function<void()> on_first_frame);

  OniStatus getSensorInfoList(OniSensorInfo** sensors, int* count) override;
  oni::driver::StreamBase* createStream(OniSensorType type) override;
  void destroyStream(oni::driver::StreamBase* stream) override;
  OniBool isPropertySupported(int property) override;
  OniStatus getProperty(int property, void* data, int* size) override;
  OniStatus setProperty(int property, const void* data, int size) override;
  OniBool isImageRegistrationModeSupported(OniImageRegistrationMode mode) override;

 private:
  std::string scene_;
  render::SceneRequest request_;
  oni::driver::DriverServices& services_;
  OniVideoMode mode_;
  OniSensorInfo depth_sensor_;
  std::shared_ptr<FaultPlan> plan_;
  std::function<void()> on_first_frame_;
  OniImageRegistrationMode registration_ = ONI_IMAGE_REGISTRATION_OFF;
};

}  // namespace cleave::driver
