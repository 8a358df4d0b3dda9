// SPDX-License-Identifier: BSD-3-Clause
#include "config/grabber_config.hpp"

#include <gtest/gtest.h>

#include "tests/unit/config/yaml_file.hpp"

namespace cleave::config {
namespace {

std::string grabber_message(const std::string& content) {
  return message_for(content, [](const auto& path) { (void)load_grabber_config(path); });
}

TEST(GrabberConfig, AsShippedHoldsTheDefaults) {
  const GrabberConfig shipped = load_grabber_config(CLEAVE_CONFIG "/grabber.yaml");
  const GrabberConfig defaults;
  EXPECT_EQ(shipped.sensor, defaults.sensor);
  EXPECT_EQ(shipped.coordinate_frame, defaults.coordinate_frame);
  EXPECT_EQ(shipped.source, defaults.source);
  EXPECT_EQ(shipped.unit, defaults.unit);
  EXPECT_EQ(shipped.fps, defaults.fps);
  EXPECT_EQ(shipped.max_gap_s, defaults.max_gap_s);
  EXPECT_EQ(shipped.decimate, defaults.decimate);
  EXPECT_EQ(shipped.loop, defaults.loop);
  EXPECT_EQ(shipped.mode, defaults.mode);
  EXPECT_EQ(shipped.window, defaults.window);
  EXPECT_EQ(shipped.video.width, defaults.video.width);
  EXPECT_EQ(shipped.video.height, defaults.video.height);
  EXPECT_EQ(shipped.video.registration, defaults.video.registration);
  EXPECT_EQ(shipped.video.mirror, defaults.video.mirror);
  EXPECT_EQ(shipped.stream.domain, defaults.stream.domain);
  EXPECT_EQ(shipped.stream.shared_memory, defaults.stream.shared_memory);
  EXPECT_EQ(shipped.stream.public_interface, defaults.stream.public_interface);
}

TEST(GrabberConfig, ReadsEveryKey) {
  const YamlFile yaml(
      "sensor: left_1\ncoordinate_frame: left_lens\nsource: pcd:scenes\nfps: 10\ndecimate: "
      "2\nloop: true\n"
      "max_gap_s: 2.5\n"
      "mode: lossless\nwindow: 2\nvideo: {width: 320, height: 240, registration: true, mirror: "
      "true}\n"
      "stream: {domain: 7, shared_memory: false, public_interface: eth0}\n");
  const GrabberConfig config = load_grabber_config(yaml.path());
  EXPECT_EQ(config.sensor, "left_1");
  EXPECT_EQ(config.coordinate_frame, "left_lens");
  EXPECT_EQ(config.source, "pcd:scenes");
  EXPECT_EQ(config.fps, 10U);
  EXPECT_EQ(config.max_gap_s, 2.5);
  EXPECT_EQ(config.decimate, 2U);
  EXPECT_TRUE(config.loop);
  EXPECT_EQ(config.mode, Mode::lossless);
  EXPECT_EQ(config.window, 2U);
  EXPECT_EQ(config.video.width, 320U);
  EXPECT_EQ(config.video.height, 240U);
  EXPECT_TRUE(config.video.registration);
  EXPECT_TRUE(config.video.mirror);
  EXPECT_EQ(config.stream.domain, 7U);
  EXPECT_FALSE(config.stream.shared_memory);
  EXPECT_EQ(config.stream.public_interface, "eth0");
}

TEST(GrabberConfig, RefusesASensorNameThatIsTooLong) {
  const std::string name(64, 'a');
  EXPECT_EQ(grabber_message("sensor: " + name + "\n"),
            "file:1: sensor: expected a sensor name of 1 to 63 letters, digits or '_' (it is "
            "part of topic names), found '" +
                name + "'");
  EXPECT_EQ(grabber_message("sensor: " + std::string(63, 'a') + "\n"), "");
}

TEST(GrabberConfig, RefusesASensorNameThatCannotBePartOfATopic) {
  EXPECT_NE(grabber_message("sensor: left/camera\n"), "");
  EXPECT_NE(grabber_message("sensor: \"\"\n"), "");
}

TEST(GrabberConfig, RefusesAnImageThatNoCloudHolds) {
  EXPECT_EQ(grabber_message("video:\n  width: 1920\n  height: 1080\n"),
            "file:3: video.height: expected at most 1920000 (1600 x 1200) pixels in all, once "
            "decimated, found '1080'");
}

TEST(GrabberConfig, TakesAnImageThatDecimationMakesSmallEnoughWhoeverAsksForIt) {
  const YamlFile large("video: {width: 1920, height: 1080}\n");
  EXPECT_EQ(load_grabber_config(large.path(), {.decimate = 2}).decimate, 2U);
  EXPECT_THROW((void)load_grabber_config(large.path()), ConfigurationError);
  const YamlFile decimated("decimate: 2\nvideo: {width: 1920, height: 1080}\n");
  EXPECT_EQ(load_grabber_config(decimated.path()).decimate, 2U);
  EXPECT_THROW((void)load_grabber_config(decimated.path(), {.decimate = 1}), ConfigurationError);
}

TEST(GrabberConfig, TakesASizeFromTheCommandLineInsteadOfItsOwn) {
  const YamlFile file("video: {width: 1920, height: 1080}\n");
  const GrabberConfig config = load_grabber_config(file.path(), {.width = 1280, .height = 720});
  EXPECT_EQ(config.video.width, 1280U);
  EXPECT_EQ(config.video.height, 720U);
  EXPECT_THROW((void)load_grabber_config(file.path(), {.width = 4096, .height = 4096}),
               ConfigurationError);
}

TEST(GrabberConfig, ReadsWhatIsKnownOfTheCamera) {
  const YamlFile file(
      "calibration:\n  fx: 600\n  fy: 601\n  cx: 319\n  cy: 241\n  depth_scale: 1.01\n"
      "  parent_frame: base_link\n  position: {x: 0.1, z: 1.2}\n"
      "  orientation: {x: -0.5, y: 0.5, z: -0.5, w: 0.5}\n");
  const CalibrationConfig known = load_grabber_config(file.path()).calibration;
  EXPECT_EQ(known.fx, 600);
  EXPECT_EQ(known.cy, 241);
  EXPECT_FLOAT_EQ(known.depth_scale, 1.01F);
  EXPECT_EQ(known.parent_frame, "base_link");
  EXPECT_FLOAT_EQ(known.position.x, .1F);
  EXPECT_EQ(known.position.y, 0);
  EXPECT_FLOAT_EQ(known.orientation.x, -.5F);
}

TEST(GrabberConfig, RefusesACalibrationThatIsHalfAOne) {
  EXPECT_NE(grabber_message("calibration: {fx: 600, cx: 320, cy: 240}\n"), "");
  EXPECT_NE(grabber_message("calibration: {cx: 320}\n"), "");
  EXPECT_NE(grabber_message("calibration: {depth_scale: 0}\n"), "");
  EXPECT_NE(grabber_message("calibration: {parent_frame: base_link}\n"), "");
  EXPECT_NE(grabber_message("calibration: {position: {x: 1}}\n"), "");
  EXPECT_NE(grabber_message("calibration: {orientation: {w: 1}}\n"), "");
  EXPECT_NE(grabber_message("calibration: {parent_frame: base_link, orientation: {w: 0.5}}\n"), "");
}

TEST(GrabberConfig, RefusesADomainOutOfRange) {
  EXPECT_EQ(grabber_message("stream:\n  domain: 100\n"),
            "file:2: stream.domain: expected a whole number from 0 to 99, found '100'");
}

TEST(GrabberConfig, RefusesAnInterfaceThatWouldBreakTheConfigurationOfDds) {
  EXPECT_NE(grabber_message("stream: {public_interface: 'lo\"/><x'}\n"), "");
  EXPECT_NE(grabber_message("stream: {public_interface: ''}\n"), "");
}

TEST(GrabberConfig, DerivesTheCoordinateFrameFromTheSensor) {
  GrabberConfig config;
  config.sensor = "left";
  EXPECT_EQ(coordinate_frame_of(config), "left_optical");
  config.coordinate_frame = "lens";
  EXPECT_EQ(coordinate_frame_of(config), "lens");
}

TEST(GrabberConfig, KeepsADerivedCoordinateFrameWithinTheContract) {
  GrabberConfig config;
  config.sensor = std::string(63, 'a');
  EXPECT_EQ(coordinate_frame_of(config).size(), 63U);
}

}  // namespace
}  // namespace cleave::config
