// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/driver/device.hpp"

#include <utility>

#include "sensor/driver/depth_stream.hpp"

namespace cleave::driver {

Device::Device(const std::string& scene, oni::driver::DriverServices& services,
               std::shared_ptr<FaultPlan> plan, std::function<void()> on_first_frame)
    : scene_(scene),
      request_(render::parse_scene(scene)),
      services_(services),
      mode_(video_mode(request_)),
      depth_sensor_{ONI_SENSOR_DEPTH, 1, &mode_},
      plan_(std::move(plan)),
      on_first_frame_(std::move(on_first_frame)) {}

OniStatus Device::getSensorInfoList(OniSensorInfo** sensors, int* count) {
  *sensors = &depth_sensor_;
  *count = 1;
  return ONI_STATUS_OK;
}

oni::driver::StreamBase* Device::createStream(OniSensorType type) {
  if (type != ONI_SENSOR_DEPTH) {
    services_.errorLoggerAppend("the synthetic camera has a depth sensor only");
    return nullptr;
  }
  return guarded<oni::driver::StreamBase*>(services_, nullptr, [this] {
    return new DepthStream(request_, services_, plan_, on_first_frame_);
  });
}

void Device::destroyStream(oni::driver::StreamBase* stream) {
  delete stream;
}

OniBool Device::isPropertySupported(int property) {
  return property == ONI_DEVICE_PROPERTY_DRIVER_VERSION ||
                 property == ONI_DEVICE_PROPERTY_SERIAL_NUMBER ||
                 property == ONI_DEVICE_PROPERTY_IMAGE_REGISTRATION
             ? TRUE
             : FALSE;
}

OniStatus Device::getProperty(int property, void* data, int* size) {
  if (property == ONI_DEVICE_PROPERTY_DRIVER_VERSION) {
    return answer(OniVersion{0, 1, 0, 0}, data, size);
  }
  if (property == ONI_DEVICE_PROPERTY_SERIAL_NUMBER) {
    const int needed = static_cast<int>(scene_.size()) + 1;
    if (*size < needed) return ONI_STATUS_BAD_PARAMETER;
    std::memcpy(data, scene_.c_str(), scene_.size() + 1);
    *size = needed;
    return ONI_STATUS_OK;
  }
  if (property == ONI_DEVICE_PROPERTY_IMAGE_REGISTRATION) return answer(registration_, data, size);
  return ONI_STATUS_NOT_SUPPORTED;
}

OniStatus Device::setProperty(int property, const void* data, int size) {
  OniImageRegistrationMode mode{};
  if (property != ONI_DEVICE_PROPERTY_IMAGE_REGISTRATION || size != sizeof mode) {
    return ONI_STATUS_NOT_SUPPORTED;
  }
  std::memcpy(&mode, data, sizeof mode);
  if (isImageRegistrationModeSupported(mode) == FALSE) return ONI_STATUS_NOT_SUPPORTED;
  registration_ = mode;
  return ONI_STATUS_OK;
}

// There is no colour image: registered depth is the same depth.
OniBool Device::isImageRegistrationModeSupported(OniImageRegistrationMode mode) {
  return mode == ONI_IMAGE_REGISTRATION_OFF || request_.registration ? TRUE : FALSE;
}

}  // namespace cleave::driver
