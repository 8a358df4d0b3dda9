// Rendered table-top scenes that behave like a real structured-light camera's, with true labels.
#pragma once

#include <cstdint>
#include <vector>

#include "sensor/renderer/scene.hpp"

namespace cleave::render {

struct Intrinsics {
  double fx = 525, fy = 525, cx = 319.5, cy = 239.5;  // pixels
};

struct CameraModel {
  std::uint32_t width = 640;
  std::uint32_t height = 480;
  Intrinsics intrinsics;
};

// Row-major; 0 = no measurement, label 0. Labels: one a visible connected part of an object (or of
// the table), 1 = the table's largest part, as in mOSD (1 to 9 table, 20 to 29 first object, ...).
struct LabelledDepth {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint16_t> depth_mm;
  std::vector<std::uint16_t> label;
};

// What rays hit, before the sensor: shared by all frames seen from one pose.
class RayCast;

// Deterministic: the same scene, pose and noise seed give the same image on every run.
[[nodiscard]] LabelledDepth render(const Scene& scene, const CameraPose& pose,
                                   const CameraModel& camera, std::uint64_t noise_seed);

// Points of a depth image: x, y, z in metres, optical frame, row-major, NaN = no measurement.
[[nodiscard]] std::vector<float> to_points(const LabelledDepth& image,
                                           const Intrinsics& intrinsics);

}  // namespace cleave::render
