// SPDX-License-Identifier: BSD-3-Clause
// The frames of a synthetic camera, which it plays in a loop.
#pragma once

#include <cstdint>
#include <optional>

#include "sensor/renderer/depth_sensor.hpp"
#include "sensor/renderer/labelled_depth.hpp"
#include "sensor/renderer/scene/scene.hpp"
#include "sensor/renderer/scene/scene_uri.hpp"
#include "sensor/renderer/view/camera.hpp"

namespace cleave::render {

// Renders any frame of the loop, in any order. Deterministic: a frame depends on the request and
// its index only. Rays are cast once for a static camera, once a frame for a moving one. One thread
// at a time.
class SceneLoop {
 public:
  explicit SceneLoop(const SceneRequest& request)
      : SceneLoop(request, camera_of_size(request.width, request.height)) {}
  // With another camera than of the request's size.
  SceneLoop(const SceneRequest& request, const CameraModel& camera);

  [[nodiscard]] std::uint32_t size() const { return request_.frames; }
  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] CameraPose pose(std::uint32_t index) const;
  // `index` below size().
  [[nodiscard]] LabelledDepth frame(std::uint32_t index);

 private:
  const DepthSensor& sensor_at(std::uint32_t index);

  SceneRequest request_;
  CameraModel camera_;
  Scene scene_;
  std::uint32_t sensor_index_ = 0;
  std::optional<DepthSensor> sensor_;  // as of the frame sensor_index_
};

}  // namespace cleave::render
