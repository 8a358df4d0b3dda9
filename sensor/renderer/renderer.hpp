// SPDX-License-Identifier: BSD-3-Clause
// Rendered table-top scenes that behave like a real structured-light camera's, with true labels.
#pragma once

#include <cstdint>

#include "sensor/renderer/labelled_depth.hpp"
#include "sensor/renderer/scene/scene.hpp"
#include "sensor/renderer/view/camera.hpp"

namespace cleave::render {

// One frame. Deterministic: the same scene, pose and noise seed give the same image on every run.
// For several frames from one pose build a DepthSensor of cast_rays() once.
[[nodiscard]] LabelledDepth render(const Scene& scene, const CameraPose& pose,
                                   const CameraModel& camera, std::uint64_t noise_seed);

}  // namespace cleave::render
