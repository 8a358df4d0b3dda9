// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/renderer/scene/scene_uri.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace cleave::render {
namespace {

std::string refusal_of(const std::string& text) {
  try {
    static_cast<void>(parse_scene(text));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

bool mentions(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(SceneUri, APresetAloneHasTheDefaults) {
  const SceneRequest request = parse_scene("medium");
  EXPECT_EQ(request.preset, "medium");
  EXPECT_EQ(request.seed, 1U);
  EXPECT_FALSE(request.objects.has_value());
  EXPECT_EQ(request.frames, 8U);
  EXPECT_FALSE(request.motion);
  EXPECT_TRUE(request.noise);
  EXPECT_EQ(request.fps, 30U);
}

TEST(SceneUri, EveryKeyIsRead) {
  const SceneRequest request = parse_scene(
      "crowded?seed=4294967295&objects=30&frames=600&motion=1&noise=0&fps=240&"
      "width=1280&height=720");
  EXPECT_EQ(request.preset, "crowded");
  EXPECT_EQ(request.seed, 4294967295U);
  EXPECT_EQ(request.objects, 30U);
  EXPECT_EQ(request.frames, 600U);
  EXPECT_TRUE(request.motion);
  EXPECT_FALSE(request.noise);
  EXPECT_EQ(request.fps, 240U);
  EXPECT_EQ(request.width, 1280U);
  EXPECT_EQ(request.height, 720U);
}

TEST(SceneUri, TellsTheCameraWhatGoesWrong) {
  const SceneRequest request = parse_scene(
      "simple?mirrored=1&registration=1&unplug_at_ms=1&replug_after_ms=2&stall_at_ms=3&stall_ms=4&"
      "in_use_ms=5&clock_reset_at_ms=6&drop_at_ms=7&drop_frames=8");
  EXPECT_TRUE(request.mirrored);
  EXPECT_TRUE(request.registration);
  EXPECT_EQ(request.faults.unplug_at_ms, 1U);
  EXPECT_EQ(request.faults.replug_after_ms, 2U);
  EXPECT_EQ(request.faults.stall_at_ms, 3U);
  EXPECT_EQ(request.faults.stall_ms, 4U);
  EXPECT_EQ(request.faults.in_use_ms, 5U);
  EXPECT_EQ(request.faults.clock_reset_at_ms, 6U);
  EXPECT_EQ(request.faults.drop_at_ms, 7U);
  EXPECT_EQ(request.faults.drop_frames, 8U);
}

TEST(SceneUri, NothingGoesWrongUnlessItIsAskedFor) {
  const CameraFaults faults = parse_scene("simple").faults;
  EXPECT_EQ(faults.unplug_at_ms + faults.stall_at_ms + faults.in_use_ms + faults.clock_reset_at_ms +
                faults.drop_at_ms,
            0U);
}

TEST(SceneUri, MotionLengthensTheLoopUnlessItsLengthIsGiven) {
  EXPECT_EQ(parse_scene("simple?motion=1").frames, 60U);
  EXPECT_EQ(parse_scene("simple?motion=1&frames=7").frames, 7U);
  EXPECT_EQ(parse_scene("simple?frames=7&motion=1").frames, 7U);
}

TEST(SceneUri, AnUnknownPresetIsRefusedWithTheKnownOnesAndAnExample) {
  const std::string text = refusal_of("kitchen?seed=1");
  EXPECT_TRUE(mentions(text, "\"kitchen\"")) << text;
  EXPECT_TRUE(mentions(text, "simple, medium, crowded")) << text;
  EXPECT_TRUE(mentions(text, "crowded?seed=3&motion=1")) << text;
}

TEST(SceneUri, AnUnknownKeyIsRefusedWithTheKnownOnes) {
  const std::string text = refusal_of("simple?sead=1");
  EXPECT_TRUE(mentions(text, "\"sead\"")) << text;
  for (const char* key : {"seed", "objects", "frames", "motion", "noise", "fps", "mirrored",
                          "registration", "unplug_at_ms", "stall_ms", "drop_frames"}) {
    EXPECT_TRUE(mentions(text, key)) << text;
  }
}

TEST(SceneUri, AValueThatIsNoNumberOrOutOfRangeIsRefusedWithTheRange) {
  EXPECT_TRUE(mentions(refusal_of("simple?objects=1"), "\"1\", not a whole number from 2 to 30"));
  EXPECT_TRUE(mentions(refusal_of("simple?objects=31"), "from 2 to 30"));
  EXPECT_TRUE(mentions(refusal_of("simple?frames=0"), "from 1 to 600"));
  EXPECT_TRUE(mentions(refusal_of("simple?frames=601"), "from 1 to 600"));
  EXPECT_TRUE(mentions(refusal_of("simple?fps=241"), "from 1 to 240"));
  EXPECT_TRUE(mentions(refusal_of("simple?motion=yes"), "from 0 to 1"));
  EXPECT_TRUE(mentions(refusal_of("simple?noise=-1"), "from 0 to 1"));
  EXPECT_TRUE(mentions(refusal_of("simple?seed=4294967296"), "from 0 to 4294967295"));
  EXPECT_TRUE(mentions(refusal_of("simple?seed=1x"), "\"1x\""));
  EXPECT_TRUE(mentions(refusal_of("simple?seed="), "\"\""));
}

TEST(SceneUri, MalformedTextIsRefused) {
  for (const char* text : {"", "?", "simple?", "simple?seed", "simple?seed=1&", "simple?seed=1&&",
                           "simple?=1", "simple?seed=1&seed=1", "Simple", " simple"}) {
    EXPECT_NE(refusal_of(text), "") << '"' << text << '"';
  }
}

}  // namespace
}  // namespace cleave::render
