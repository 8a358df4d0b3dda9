// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/bench/bench.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/box_scene.hpp"
#include "workbench/bench/bench_report.hpp"

namespace cleave::workbench {
namespace {

evaluation::LabelledCloud boxes() {
  return tests::render_touching_boxes(160, 120);
}

TEST(Bench, TimesEveryStageOfEveryRun) {
  Bench bench({.repeat = 3, .grid_offsets = 2});

  bench.measure("boxes", boxes());

  EXPECT_EQ(bench.result().ours.run_ms.size(), 6U);
  EXPECT_EQ(bench.result().times.of(segmentation::Stage::partition).size(), 6U);
  EXPECT_EQ(bench.result().ours.qualities.size(), 2U);  // one a grid: repeats give the same labels
  EXPECT_EQ(bench.result().points, std::vector<double>{19200});
}

TEST(Bench, PutsPclBesideOursInTheSameRun) {
  Bench bench({.against_pcl = true});

  bench.measure("boxes", tests::render_touching_boxes());

  const Json json = json_of(bench.result());
  for (const char* peer : {"pcl_ssc", "pcl_lccp", "pcl_lccp_tuned"}) {
    const double peer_ms = json[peer]["milliseconds"]["median"];
    const double our_ms = json["milliseconds"]["median"];
    EXPECT_DOUBLE_EQ(json["ratio"][peer], peer_ms / our_ms);
    EXPECT_GT(json[peer]["weighted_covering"]["min"], 0.5);
  }
  EXPECT_NE(text_of(bench.result()).find("pcl_lccp_tuned"), std::string::npos);
}

TEST(Bench, HasTheKeysThatProgramsReadWhetherOrNotThereIsATruth) {
  evaluation::LabelledCloud cloud = boxes();
  cloud.label.clear();
  Bench bench({});

  bench.measure("boxes", cloud);

  const Json json = json_of(bench.result());
  EXPECT_EQ(json["scenes"], 1);
  EXPECT_TRUE(json["weighted_covering"].is_null());
  EXPECT_TRUE(json["stages"]["voxelise"].contains("median_ms"));
  EXPECT_TRUE(json["milliseconds"].contains("p99"));
  EXPECT_TRUE(json.contains("allocations"));
  EXPECT_FALSE(json.contains("ratio"));
}

TEST(Bench, FindsARunThatWentBadlyWrongWhereTheThesisDoesNot) {
  segmentation::Options broken;
  broken.clean_up.min_segment_points = 1000000;  // joins everything
  evaluation::LabelledCloud scene = tests::render_touching_boxes();
  for (std::size_t i = 0; i < scene.size(); ++i) {
    if (scene.label[i] == 1 && i % 8 != 0) scene.label[i] = 0;  // the table is not all that counts
  }
  Bench bench({.options = broken, .find_collapses = true});
  Bench sound({.find_collapses = true});

  bench.measure("boxes", scene);
  sound.measure("boxes", scene);

  ASSERT_EQ(bench.result().collapses.size(), 1U) << json_of(bench.result());
  EXPECT_LT(bench.result().collapses[0].weighted_covering, collapsed_below);
  EXPECT_GE(bench.result().collapses[0].of_thesis, thesis_reaches);
  EXPECT_NE(collapse_text(bench.result()).find("boxes at grid offset"), std::string::npos);
  EXPECT_EQ(collapse_json(bench.result())[0]["cloud"], "boxes");
  EXPECT_TRUE(sound.result().collapses.empty());
}

TEST(Bench, RefusesACloudWithoutAPoint) {
  evaluation::LabelledCloud cloud{.width = 1, .height = 1, .xyz = {NAN, NAN, NAN}, .label = {}};

  EXPECT_THROW(Bench({}).measure("empty.pcd", cloud), std::runtime_error);
}

}  // namespace
}  // namespace cleave::workbench
