// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/renderer/scene/scene_loop.hpp"

#include "sensor/renderer/scene/random.hpp"
#include "sensor/renderer/view/ray_cast.hpp"

namespace cleave::render {
namespace {

Scene requested_scene(const SceneRequest& request) {
  SceneParameters parameters = scene_parameters(request.preset, request.seed);
  if (request.objects) parameters.min_objects = parameters.max_objects = *request.objects;
  return make_scene(parameters);
}

}  // namespace

SceneLoop::SceneLoop(const SceneRequest& request, const CameraModel& camera)
    : request_(request), camera_(camera), scene_(requested_scene(request)) {}

CameraPose SceneLoop::pose(std::uint32_t index) const {
  if (!request_.motion) return scene_.camera;
  return pose_on_loop(scene_.camera, static_cast<double>(index) / request_.frames);
}

LabelledDepth SceneLoop::frame(std::uint32_t index) {
  const DepthSensor& sensor = sensor_at(index);
  if (!request_.noise) return sensor.measure_without_noise();
  return sensor.measure(derived_seed(request_.seed, index));
}

const DepthSensor& SceneLoop::sensor_at(std::uint32_t index) {
  const bool still_valid = sensor_ && (!request_.motion || sensor_index_ == index);
  if (!still_valid) sensor_.emplace(cast_rays(scene_, pose(index), camera_));
  sensor_index_ = index;
  return *sensor_;
}

}  // namespace cleave::render
