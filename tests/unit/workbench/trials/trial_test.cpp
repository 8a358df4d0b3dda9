// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/trials/trial.hpp"

#include <gtest/gtest.h>

#include "tests/unit/workbench/trials/labelled_folder.hpp"
#include "workbench/cloud/option_setter.hpp"

namespace cleave::workbench {
namespace {

const TrialProgress silent = [](std::size_t, std::size_t) {};

std::vector<double> coverings(const std::vector<Scene>& scenes) {
  std::vector<double> values;
  for (const Scene& scene : scenes) {
    for (const auto& runs : scene.runs) {
      for (const Run& run : runs) {
        values.insert(values.end(), {run.quality.weighted_covering, run.boundary.f});
      }
    }
  }
  return values;
}

TEST(Trial, RunsEveryMethodOnEveryGridOfEveryScene) {
  const LabelledFolder folder;
  std::size_t last = 0;
  std::size_t all_runs = 0;

  const auto scenes = try_scenes(
      {.methods = {method_named("ssc", {}), method_named("thesis", {})}, .grid_offsets = 3},
      folder.files(), [&](std::size_t done, std::size_t all) {
        EXPECT_GT(done, last);
        last = done;
        all_runs = all;
      });

  ASSERT_EQ(scenes.size(), 3U);
  EXPECT_EQ(scenes[1].file.filename(), "scene2.pcd");
  EXPECT_EQ(scenes[2].file.filename(), "scene10.pcd");
  for (const Scene& scene : scenes) {
    ASSERT_EQ(scene.runs.size(), 2U) << scene.problem;
    for (const auto& runs : scene.runs) {
      ASSERT_EQ(runs.size(), 3U);
      EXPECT_FLOAT_EQ(runs[1].grid_offset, 1.0F / 3);
      EXPECT_GT(runs[0].quality.weighted_covering, 0.9) << scene.file;
      EXPECT_GT(runs[0].milliseconds, 0);
    }
  }
  EXPECT_EQ(scenes[0].true_segments, 3U);
  EXPECT_EQ(scenes[2].true_segments, 1U);
  EXPECT_EQ(last, 18U);
  EXPECT_EQ(all_runs, 18U);
}

TEST(Trial, GivesTheSameForAnyNumberOfJobs) {
  const LabelledFolder folder;
  TrialPlan plan{.methods = {method_named("ssc", {})}, .grid_offsets = 2};

  const auto alone = coverings(try_scenes(plan, folder.files(), silent));
  plan.jobs = 5;
  const auto together = coverings(try_scenes(plan, folder.files(), silent));

  EXPECT_EQ(alone.size(), 12U);
  EXPECT_EQ(alone, together);
}

TEST(Trial, SkipsWhatCannotBeJudgedAndSaysWhy) {
  const LabelledFolder folder;
  folder.add_damaged("scene3.pcd");
  folder.add_unlabelled("scene4.pcd");

  const auto scenes =
      try_scenes({.methods = {method_named("ssc", {})}, .jobs = 2}, folder.files(), silent);

  ASSERT_EQ(scenes.size(), 5U);
  EXPECT_TRUE(scenes[0].tried());
  EXPECT_NE(scenes[2].problem.find("scene3.pcd"), std::string::npos);
  EXPECT_NE(scenes[3].problem.find("no field label"), std::string::npos) << scenes[3].problem;
  EXPECT_TRUE(scenes[4].tried());
}

TEST(Trial, RunsPclsMethodsOnceAScene) {
  const LabelledFolder folder;

  const auto scenes = try_scenes(
      {.methods = {method_named("lccp-tuned", {}), method_named("cpc", {})}, .grid_offsets = 4},
      {folder.files().front()}, silent);

  ASSERT_EQ(scenes[0].runs.size(), 2U);
  for (const auto& runs : scenes[0].runs) {
    ASSERT_EQ(runs.size(), 1U);
    EXPECT_GT(runs[0].quality.weighted_covering, 0.8);
  }
}

TEST(Trial, StopsWhenAPictureCannotBeWritten) {
  const LabelledFolder folder;

  EXPECT_THROW((void)try_scenes({.methods = {method_named("ssc", {})},
                                 .jobs = 2,
                                 .pictures = folder.path() / "not there"},
                                folder.files(), silent),
               std::runtime_error);
}

TEST(Method, IsKnownByNameWithSettingsOnTopOfItsOwnValues) {
  EXPECT_EQ(method_named("thesis-constrained-ssc", {"voxel.size_m=0.01"}).name,
            "thesis-constrained-ssc");
  EXPECT_NE(method_names().find("ssc, "), std::string::npos);
}

TEST(Method, ThatIsNotKnownIsRefusedWithThoseThatAre) {
  try {
    (void)method_named("magic", {});
    FAIL() << "no such method";
  } catch (const OptionError& error) {
    EXPECT_NE(std::string(error.what()).find("lccp-tuned"), std::string::npos) << error.what();
  }
  EXPECT_THROW((void)method_named("ssc", {"voxel.colour=red"}), OptionError);
}

TEST(Method, IsRefusedWithASettingThatItWouldIgnore) {
  try {
    (void)method_named("convex-components", {"partition.eigenvectors=4"});
    FAIL() << "nothing is cut";
  } catch (const OptionError& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("partition.eigenvectors is 4, but algorithm convex-components"),
              std::string::npos)
        << what;
  }
  for (const char* const name : {"svc", "thesis-svc", "thesis-convex-components"}) {
    EXPECT_EQ(method_named(name, {"voxel.size_m=0.01"}).name, name);
  }
}

}  // namespace
}  // namespace cleave::workbench
