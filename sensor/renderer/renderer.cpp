// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/renderer/renderer.hpp"

#include "sensor/renderer/depth_sensor.hpp"
#include "sensor/renderer/view/ray_cast.hpp"

namespace cleave::render {

LabelledDepth render(const Scene& scene, const CameraPose& pose, const CameraModel& camera,
                     std::uint64_t noise_seed) {
  return DepthSensor(cast_rays(scene, pose, camera)).measure(noise_seed);
}

}  // namespace cleave::render
