// SPDX-License-Identifier: BSD-3-Clause
#include "segmenter/settings.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "segmenter/command_line.hpp"
#include "tests/unit/config/yaml_file.hpp"

namespace cleave::service {
namespace {

using config::YamlFile;

class SegmenterSettings : public testing::Test {
 protected:
  SegmenterSettings() { ::unsetenv("CLEAVE_DOMAIN"); }
  ~SegmenterSettings() override { ::unsetenv("CLEAVE_DOMAIN"); }
};

CommandLine line_with(const std::string& config_file) {
  CommandLine line;
  line.config_file = config_file;
  return line;
}

DaemonSettings settings_of(const std::string& yaml) {
  const YamlFile file(yaml);
  return read_settings(line_with(file.path()));
}

std::string refusal(const std::string& yaml) {
  return config::message_for(yaml, [](const auto& path) { (void)read_settings(line_with(path)); });
}

TEST_F(SegmenterSettings, HoldTheDefaultsForAnEmptyMapping) {
  const DaemonSettings settings = settings_of("{}");

  EXPECT_EQ(settings.sensors, (std::vector<std::string>{"camera"}));
  EXPECT_EQ(settings.mode, Mode::live);
  EXPECT_EQ(settings.segmentation.voxel.size_m, segmentation::Options().voxel.size_m);
}

TEST_F(SegmenterSettings, TakeOptionsOfEveryKindFromTheSectionSegmentation) {
  const DaemonSettings settings = settings_of(
      "segmentation:\n"
      "  algorithm: constrained-ssc\n"
      "  representation: voxels\n"
      "  voxel: {size_m: 0.01, viewpoint: single, neighbourhood: 18}\n"
      "  supervoxel: {sweeps: 3}\n"
      "  refine: {boundary: false}\n");

  EXPECT_EQ(settings.segmentation.algorithm, segmentation::Algorithm::constrained_ssc);
  EXPECT_FLOAT_EQ(settings.segmentation.voxel.size_m, 0.01F);
  EXPECT_EQ(settings.segmentation.voxel.neighbourhood, segmentation::Neighbourhood::edges);
  EXPECT_EQ(settings.segmentation.voxel.viewpoint, segmentation::Viewpoint::single);
  EXPECT_EQ(settings.segmentation.supervoxel.sweeps, 3U);
  EXPECT_FALSE(settings.segmentation.refine.boundary);
}

TEST_F(SegmenterSettings, RefuseAnOptionThatDoesNotExistWithItsLine) {
  const std::string message = refusal("segmentation:\n  voxel:\n    sise_m: 0.01\n");

  EXPECT_NE(message.find("file:3: segmentation.voxel.sise_m"), std::string::npos) << message;
}

TEST_F(SegmenterSettings, RefuseAnOptionOutOfItsRange) {
  const std::string message = refusal("segmentation:\n  voxel: {size_m: -1}\n");

  EXPECT_NE(message.find("segmentation.voxel.size_m: expected a number from"), std::string::npos)
      << message;
}

TEST_F(SegmenterSettings, RefuseAnOptionThatTheAlgorithmDoesNotReadWithItsLine) {
  const std::string message =
      refusal("segmentation:\n  algorithm: svc\n  graph:\n    max_step_m: 0.01\n");

  EXPECT_NE(message.find("file:4: segmentation.graph.max_step_m: expected no value, as algorithm "
                         "svc does not read it (or set algorithm to ssc"),
            std::string::npos)
      << message;
}

TEST_F(SegmenterSettings, RefuseAnOptionOfVoxelsWhereImagesBecomeCells) {
  const std::string message = refusal("segmentation:\n  voxel: {neighbourhood: 18}\n");

  EXPECT_NE(message.find("file:2: segmentation.voxel.neighbourhood"), std::string::npos) << message;
  EXPECT_NE(message.find("set representation to voxels"), std::string::npos) << message;
}

TEST_F(SegmenterSettings, PreferArgumentsToTheFile) {
  const YamlFile file("sensors: [left, right]\nworkers: 1\nmode: live\n");
  CommandLine with_arguments = line_with(file.path());
  with_arguments.sensor = "wrist";
  with_arguments.workers = 3;
  with_arguments.lossless = true;
  with_arguments.no_shared_memory = true;

  const DaemonSettings settings = read_settings(with_arguments);

  EXPECT_EQ(settings.sensors, (std::vector<std::string>{"wrist"}));
  EXPECT_EQ(settings.workers, 3U);
  EXPECT_EQ(settings.mode, Mode::lossless);
  EXPECT_EQ(settings.queue_capacity, 8U);
  EXPECT_FALSE(settings.stream.shared_memory);
}

TEST_F(SegmenterSettings, PreferTheEnvironmentsDomain) {
  ASSERT_EQ(::setenv("CLEAVE_DOMAIN", "17", 1), 0);

  EXPECT_EQ(settings_of("stream: {domain: 4}\n").stream.domain, 17U);
}

TEST_F(SegmenterSettings, RefuseASensorNameThatIsNoTopicName) {
  const YamlFile file("{}");
  CommandLine with_sensor = line_with(file.path());
  with_sensor.sensor = "front/left";

  EXPECT_THROW((void)read_settings(with_sensor), std::invalid_argument);
}

std::variant<CommandLine, int> parse(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "cleave-segmenter");
  return parse_command_line(static_cast<int>(arguments.size()), arguments.data());
}

TEST(SegmenterCommandLine, HoldsWhatWasTyped) {
  const auto parsed = parse({"--config", "a.yaml", "--workers", "2", "--lossless"});

  const auto& line = std::get<CommandLine>(parsed);
  EXPECT_EQ(line.config_file, "a.yaml");
  EXPECT_EQ(line.workers, 2U);
  EXPECT_TRUE(line.lossless);
  EXPECT_FALSE(line.sensor);
}

TEST(SegmenterCommandLine, EndsWith0AfterHelp) {
  EXPECT_EQ(std::get<int>(parse({"--help"})), 0);
}

TEST(SegmenterCommandLine, EndsWith2ForWrongUsage) {
  EXPECT_EQ(std::get<int>(parse({"--config", "a.yaml", "--no-such-option"})), 2);
  EXPECT_EQ(std::get<int>(parse({"--config", "a.yaml", "--workers", "7"})), 2);
  EXPECT_EQ(std::get<int>(parse({"--config", "a.yaml", "--workers", "many"})), 2);
}

}  // namespace
}  // namespace cleave::service
