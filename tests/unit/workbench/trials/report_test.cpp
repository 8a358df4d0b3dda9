// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/trials/report.hpp"

#include <gtest/gtest.h>

#include "workbench/trials/csv.hpp"
#include "workbench/trials/measures.hpp"

namespace cleave::workbench {
namespace {

Run run_with(double covering) {
  Run run;
  run.quality.weighted_covering = covering;
  run.quality.unweighted_covering = covering / 2;
  run.quality.over = 3;
  run.quality.found_segments = 6;
  run.boundary.f = 0.25;
  run.milliseconds = 1.5;
  return run;
}

// Two methods on three scenes, the second of which could not be read.
TrialResult result() {
  TrialResult result;
  result.methods = {"ssc", "lccp"};
  result.scenes.resize(3);
  result.scenes[0] = {"a.pcd", "", 100, 4, {{run_with(0.5), run_with(1)}, {run_with(0.25)}}};
  result.scenes[1] = {"b.pcd", "b.pcd: is damaged", 0, 0, {}};
  result.scenes[2] = {"c, d.pcd", "", 100, 5, {{run_with(1), run_with(1)}, {run_with(0.75)}}};
  result.groups = {{0, 1}, {1, 1}};
  return result;
}

TEST(TrialReport, HasTheKeysThatProgramsRead) {
  const Json json = json_of(result());

  EXPECT_EQ(json["scenes"], 2);
  EXPECT_EQ(json["skipped"], 1);
  EXPECT_DOUBLE_EQ(json["weighted_covering"]["mean"], 3.5 / 4);
  EXPECT_DOUBLE_EQ(json["weighted_covering"]["min"], 0.5);
  EXPECT_DOUBLE_EQ(json["unweighted_covering"]["mean"], 3.5 / 8);
  EXPECT_DOUBLE_EQ(json["under_segmentation"]["mean"], 0);
  EXPECT_DOUBLE_EQ(json["over_segmentation"]["mean"], 3);
  EXPECT_DOUBLE_EQ(json["boundary_f"]["mean"], 0.25);
  for (const char* key : {"object_f", "object_precision", "object_recall"}) {
    EXPECT_TRUE(json[key].contains("mean")) << key;
  }
  EXPECT_DOUBLE_EQ(json["milliseconds"]["median"], 1.5);
}

TEST(TrialReport, HoldsAllAlgorithmsAndTheFirstAtTheTop) {
  const Json json = json_of(result());

  EXPECT_EQ(json["algorithm"], "ssc");
  EXPECT_DOUBLE_EQ(json["algorithms"]["lccp"]["weighted_covering"]["mean"], 0.5);
  EXPECT_EQ(json["algorithms"]["lccp"]["runs"], 2);
  EXPECT_EQ(json["algorithms"]["ssc"]["weighted_covering"], json["weighted_covering"]);
}

TEST(TrialReport, SumsUpGroupsAndSaysNothingOfAnEmptyOne) {
  const Json json = json_of(result());

  EXPECT_EQ(json["groups"][0]["group"], "0-1");
  EXPECT_DOUBLE_EQ(json["groups"][0]["weighted_covering"]["mean"], 0.75);
  EXPECT_TRUE(json["groups"][1]["weighted_covering"].is_null());
}

TEST(TrialReport, TellsWhyASceneWasSkipped) {
  const Json json = json_of(result());

  ASSERT_EQ(json["per_scene"].size(), 3U);
  EXPECT_EQ(json["per_scene"][1]["problem"], "b.pcd: is damaged");
  EXPECT_DOUBLE_EQ(json["per_scene"][0]["algorithms"]["ssc"]["weighted_covering"], 0.75);
}

TEST(TrialReport, ShowsOneAlgorithmInFullAndSeveralSideBySide) {
  TrialResult several = result();
  EXPECT_NE(text_of(several).find("2 scenes, 1 skipped"), std::string::npos);
  EXPECT_NE(text_of(several).find("Scenes 0-1, 1 of them"), std::string::npos);
  EXPECT_NE(text_of(several).find("none could be read"), std::string::npos);

  several.methods = {"ssc"};
  EXPECT_NE(text_of(several).find("boundary F"), std::string::npos);
  EXPECT_NE(text_of(several).find("c, d.pcd"), std::string::npos);
}

TEST(TrialCsv, HasALineARun) {
  const std::string csv = csv_of(result());

  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 6);
  EXPECT_NE(csv.find("index,file,algorithm,grid_offset,points,true_segments,found_segments,"
                     "weighted_covering,"),
            std::string::npos);
  EXPECT_NE(csv.find("\n0,a.pcd,lccp,0,100,4,6,0.25,0.125,0,3,0.25,"), std::string::npos) << csv;
  EXPECT_NE(csv.find("\n2,\"c, d.pcd\",ssc,"), std::string::npos) << csv;
}

TEST(TrialCsv, QuotesWhatWouldBreakALine) {
  EXPECT_EQ(csv_field("plain name.pcd"), "plain name.pcd");
  EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_field("say \"x\""), "\"say \"\"x\"\"\"");
}

}  // namespace
}  // namespace cleave::workbench
