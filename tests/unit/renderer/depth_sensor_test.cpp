// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/renderer/depth_sensor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sensor/renderer/scene/scene.hpp"

namespace cleave::render {
namespace {

struct Frame {
  RayCast rays;
  LabelledDepth measured;
};

Frame frame_of(const std::string& preset, std::uint32_t seed) {
  const Scene scene = make_scene(scene_parameters(preset, seed));
  RayCast rays = cast_rays(scene, scene.camera, {});
  LabelledDepth measured = DepthSensor(rays).measure(seed);
  return {std::move(rays), std::move(measured)};
}

// Error of each table pixel in mm / z^2, NaN elsewhere.
std::vector<double> table_errors(const Frame& frame) {
  std::vector<double> errors(frame.rays.depth_m.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (frame.measured.label[i] != 1 || frame.rays.surface[i] != table_surface) continue;
    const double z_m = frame.rays.depth_m[i];
    errors[i] = (frame.measured.depth_mm[i] - 1000 * z_m) / (z_m * z_m);
  }
  return errors;
}

TEST(DepthSensor, TheTablesNoiseIsThatOfRealScenes) {
  double squares = 0;
  double count = 0;
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    for (const double error : table_errors(frame_of("simple", seed))) {
      if (std::isnan(error)) continue;
      squares += error * error;
      ++count;
    }
  }
  EXPECT_NEAR(std::sqrt(squares / count), 2.75, 0.15);
}

TEST(DepthSensor, TheTablesNoiseIsCorrelatedAsInRealScenes) {
  constexpr std::size_t lags[] = {1, 2, 4, 8, 16};
  constexpr double measured[] = {0.85, 0.77, 0.65, 0.47, 0.42};
  double products[5] = {};
  double counts[5] = {};
  double squares = 0;
  double count = 0;
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    const std::vector<double> errors = table_errors(frame_of("simple", seed));
    for (std::size_t i = 0; i < errors.size(); ++i) {
      if (std::isnan(errors[i])) continue;
      squares += errors[i] * errors[i];
      ++count;
      for (int k = 0; k < 5; ++k) {
        if (i % 640 + lags[k] >= 640 || std::isnan(errors[i + lags[k]])) continue;
        products[k] += errors[i] * errors[i + lags[k]];
        ++counts[k];
      }
    }
  }
  for (int k = 0; k < 5; ++k) {
    EXPECT_NEAR(products[k] / counts[k] / (squares / count), measured[k], 0.06) << lags[k];
  }
}

TEST(DepthSensor, EveryDepthIsThatOfAWholeDisparity) {
  const Frame frame = frame_of("crowded", 2);
  for (const std::uint16_t depth_mm : frame.measured.depth_mm) {
    if (depth_mm == 0) continue;
    const double disparity = std::round(348000.0 / depth_mm);
    EXPECT_EQ(depth_mm, std::lround(348000.0 / disparity));
  }
}

TEST(DepthSensor, AMeasurementHasALabelAndALabelAMeasurement) {
  const Frame frame = frame_of("crowded", 3);
  for (std::size_t i = 0; i < frame.measured.label.size(); ++i) {
    EXPECT_EQ(frame.measured.depth_mm[i] == 0, frame.measured.label[i] == 0);
  }
}

TEST(DepthSensor, SomeButFewMeasurablePixelsAreMissing) {
  const Frame frame = frame_of("crowded", 3);
  const LabelledDepth perfect = DepthSensor(frame.rays).measure_without_noise();
  double missing = 0;
  double measurable = 0;
  for (std::size_t i = 0; i < perfect.label.size(); ++i) {
    if (perfect.label[i] == 0) continue;
    ++measurable;
    if (frame.measured.label[i] == 0) ++missing;
  }
  EXPECT_GT(missing / measurable, 0.002);
  EXPECT_LT(missing / measurable, 0.05);
}

TEST(DepthSensor, WithoutNoiseDepthIsExactToTheMillimetre) {
  const Scene scene = make_scene(scene_parameters("medium", 1));
  const RayCast rays = cast_rays(scene, scene.camera, {});
  const LabelledDepth image = DepthSensor(rays).measure_without_noise();
  int pixels = 0;
  for (std::size_t i = 0; i < image.depth_mm.size(); ++i) {
    if (image.depth_mm[i] == 0) continue;
    ++pixels;
    EXPECT_NEAR(image.depth_mm[i], 1000 * rays.depth_m[i], 0.5001);
  }
  EXPECT_GT(pixels, 150000);
}

TEST(DepthSensor, AnotherSeedGivesOtherNoiseAndTheSameOneTheSame) {
  const Scene scene = make_scene(scene_parameters("simple", 1));
  const DepthSensor sensor(cast_rays(scene, scene.camera, {}));
  EXPECT_EQ(sensor.measure(1).depth_mm, sensor.measure(1).depth_mm);
  EXPECT_NE(sensor.measure(1).depth_mm, sensor.measure(2).depth_mm);
}

TEST(DepthSensor, PointsAreTheDepthImageThroughTheIntrinsics) {
  const LabelledDepth image{2, 1, {0, 1000}, {0, 1}};
  const std::vector<float> points = to_points(image, {100, 200, 0.5, 1});
  EXPECT_TRUE(std::isnan(points[0]) && std::isnan(points[1]) && std::isnan(points[2]));
  EXPECT_FLOAT_EQ(points[3], 0.005F);
  EXPECT_FLOAT_EQ(points[4], -0.005F);
  EXPECT_FLOAT_EQ(points[5], 1);
}

}  // namespace
}  // namespace cleave::render
