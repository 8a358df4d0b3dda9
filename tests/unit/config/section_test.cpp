// SPDX-License-Identifier: BSD-3-Clause
#include "config/section.hpp"

#include <gtest/gtest.h>

#include "tests/unit/config/yaml_file.hpp"

namespace cleave::config {
namespace {

// Reads the keys that the tests below use.
void load_example(const std::filesystem::path& path) {
  Section file = Section::load(path);
  std::uint32_t fps = 30;
  float size_m = 0.006F;
  bool loop = false;
  std::string name = "camera";
  std::size_t mode = 0;
  std::vector<std::string> sensors;
  file.integer("fps", fps, 1, 240);
  file.number("size_m", size_m, 0.001, 0.1);
  file.boolean("loop", loop);
  file.text("name", name);
  file.choice("mode", mode, {"live", "lossless"});
  file.list("sensors", sensors);
  Section video = file.section("video");
  video.integer("width", fps, 1, 640);
  file.finish();
}

std::string message(const std::string& content) {
  return message_for(content, load_example);
}

TEST(Section, LeavesTheDefaultWhereAKeyIsAbsent) {
  const YamlFile yaml("other: 1\n");
  Section file = Section::load(yaml.path());
  std::uint32_t fps = 30;
  std::string name = "camera";
  file.integer("fps", fps, 1, 240);
  file.text("name", name);
  EXPECT_EQ(fps, 30U);
  EXPECT_EQ(name, "camera");
}

TEST(Section, ReadsEveryKindOfValue) {
  const YamlFile yaml(
      "fps: 15\nsize_m: 7.5e-3\nloop: true\nname: \"30\"\nmode: lossless\n"
      "sensors: [left, right]\nvideo: {width: 320}\n");
  Section file = Section::load(yaml.path());
  std::uint32_t fps = 0, width = 0;
  double size_m = 0;
  bool loop = false;
  std::string name;
  std::size_t mode = 0;
  std::vector<std::string> sensors = {"camera"};
  file.integer("fps", fps, 1, 240);
  file.number("size_m", size_m, 0.001, 0.1);
  file.boolean("loop", loop);
  file.text("name", name);
  file.choice("mode", mode, {"live", "lossless"});
  file.list("sensors", sensors);
  file.section("video").integer("width", width, 1, 640);
  file.finish();
  EXPECT_EQ(fps, 15U);
  EXPECT_DOUBLE_EQ(size_m, 0.0075);
  EXPECT_TRUE(loop);
  EXPECT_EQ(name, "30");
  EXPECT_EQ(mode, 1U);
  EXPECT_EQ(sensors, (std::vector<std::string>{"left", "right"}));
  EXPECT_EQ(width, 320U);
}

TEST(Section, NamesFileLineAndKnownKeysForAnUnknownKey) {
  EXPECT_EQ(message("loop: true\nfsp: 30\n"),
            "file:2: fsp: unknown key; did you mean 'fps'? Known here: fps, size_m, loop, name, "
            "mode, sensors, video");
}

TEST(Section, NamesTheFullPathOfAnUnknownKeyBelow) {
  EXPECT_EQ(message("video:\n  width: 320\n  colour: red\n"),
            "file:3: video.colour: unknown key; Known here: width");
}

TEST(Section, RefusesAWrongType) {
  EXPECT_EQ(message("fps: fast\n"),
            "file:1: fps: expected a whole number from 1 to 240, found 'fast'");
  EXPECT_EQ(message("fps: 29.97\n"),
            "file:1: fps: expected a whole number from 1 to 240, found '29.97'");
  EXPECT_EQ(message("fps: \"30\"\n"),
            "file:1: fps: expected a whole number from 1 to 240, found '30'");
  EXPECT_EQ(message("size_m:\n"),
            "file:1: size_m: expected a number from 0.001 to 0.1, found nothing");
  EXPECT_EQ(message("loop: yes\n"), "file:1: loop: expected true or false, found 'yes'");
  EXPECT_EQ(message("name: [a]\n"), "file:1: name: expected a text, found a list");
  EXPECT_EQ(message("mode: fast\n"), "file:1: mode: expected one of live, lossless, found 'fast'");
  EXPECT_EQ(message("sensors: left\n"), "file:1: sensors: expected a list, [a, b], found 'left'");
  EXPECT_EQ(message("sensors:\n  - left\n  - [right]\n"),
            "file:3: sensors[1]: expected a text, found a list");
  EXPECT_EQ(message("video: 640\n"), "file:1: video: expected a section, found '640'");
}

TEST(Section, RefusesANumberOutOfItsRange) {
  EXPECT_EQ(message("fps: 241\n"),
            "file:1: fps: expected a whole number from 1 to 240, found '241'");
  EXPECT_EQ(message("fps: -1\n"), "file:1: fps: expected a whole number from 1 to 240, found '-1'");
  EXPECT_EQ(message("fps: 99999999999\n"),
            "file:1: fps: expected a whole number from 1 to 240, found '99999999999'");
  EXPECT_EQ(message("size_m: 0.2\n"),
            "file:1: size_m: expected a number from 0.001 to 0.1, found '0.2'");
  EXPECT_EQ(message("size_m: nan\n"),
            "file:1: size_m: expected a number from 0.001 to 0.1, found 'nan'");
}

TEST(Section, TakesTheEndsOfARange) {
  EXPECT_EQ(message("fps: 1\n"), "");
  EXPECT_EQ(message("fps: 240\n"), "");
}

TEST(Section, RefusesAFileThatIsNotAMapping) {
  EXPECT_EQ(message("- a\n- b\n"), "file:1: expected keys with values, 'key: value', found a list");
  EXPECT_EQ(message("text\n"), "file:1: expected keys with values, 'key: value', found 'text'");
  EXPECT_EQ(message(""), "file:1: expected keys with values, 'key: value', found nothing");
}

TEST(Section, RefusesAKeyThatStandsThereTwice) {
  EXPECT_EQ(message("fps: 10\nloop: true\nfps: 20\n"), "file:3: fps: stands there twice");
}

TEST(Section, RefusesASecondDocument) {
  EXPECT_EQ(message("fps: 10\n---\nfps: 20\n"), "file:3: expected one document, found more");
}

TEST(Section, NamesTheLineThatIsNotYaml) {
  const std::string text = message("fps: 30\nvideo: {width: 320\n");
  EXPECT_EQ(text.rfind("file:3: this is not YAML: ", 0), 0U) << text;
}

TEST(Section, SaysThatAFileIsMissing) {
  try {
    (void)Section::load("/nowhere/grabber.yaml");
    FAIL();
  } catch (const ConfigurationError& error) {
    EXPECT_STREQ(error.what(),
                 "/nowhere/grabber.yaml: cannot read the configuration: there is no such file");
  }
}

TEST(Section, SaysThatAFileIsAFolder) {
  EXPECT_THROW((void)Section::load("/tmp"), ConfigurationError);
}

TEST(Section, TakesASectionWithoutKeysForAnAbsentOne) {
  EXPECT_EQ(message("video:\n"), "");
}

}  // namespace
}  // namespace cleave::config
