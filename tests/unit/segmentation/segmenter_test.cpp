// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/segmenter.hpp"

#include <gtest/gtest.h>

#include <map>

#include "tests/support/box_scene.hpp"
#include "tests/unit/segmentation/support/segment_cloud.hpp"
#include "workbench/evaluation/quality.hpp"

namespace cleave::segmentation {
namespace {

using evaluation::LabelledCloud;
using tests::render_touching_boxes;

TEST(Segmenter, FindsTheTableAndTwoTouchingBoxes) {
  const LabelledCloud scene = render_touching_boxes();
  Segmenter segmenter;

  const Segmented result = segment(segmenter, scene.view());

  ASSERT_EQ(result.outcome, Outcome::segmented);
  EXPECT_EQ(result.segmentation.segments.size(), 3U);
  EXPECT_GT(evaluation::judge(scene.label, result.labels).unweighted_covering, 0.98);
}

TEST(Segmenter, LabelsExactlyTheFinitePoints) {
  const LabelledCloud scene = render_touching_boxes();
  Segmenter segmenter;

  const Segmented result = segment(segmenter, scene.view());

  for (std::size_t i = 0; i < scene.label.size(); ++i) {
    EXPECT_EQ(result.labels[i] > 0, scene.label[i] > 0);
  }
}

TEST(Segmenter, DescribesSegmentsAsTheirLabelsSay) {
  const LabelledCloud scene = render_touching_boxes();
  Segmenter segmenter;

  const Segmented result = segment(segmenter, scene.view());

  std::uint32_t last_count = std::numeric_limits<std::uint32_t>::max();
  for (std::size_t s = 0; s < result.segmentation.segments.size(); ++s) {
    const Segment& found = result.segmentation.segments[s];
    EXPECT_EQ(found.label, s + 1);
    EXPECT_LE(found.point_count, last_count);
    last_count = found.point_count;

    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    ImageRectangle r{scene.width, scene.height, 0, 0};
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < result.labels.size(); ++i) {
      if (result.labels[i] != found.label) continue;
      const Eigen::Vector3f p(scene.xyz.data() + 3 * std::size_t{i});
      sum += p.cast<double>();
      ++count;
      r = {std::min(r.left, i % scene.width), std::min(r.top, i / scene.width),
           std::max(r.right, i % scene.width + 1), std::max(r.bottom, i / scene.width + 1)};
      const Eigen::Vector3f in_box = found.box.orientation.conjugate() * (p - found.box.centre);
      EXPECT_TRUE((in_box.cwiseAbs() - found.box.extent / 2).maxCoeff() < 1e-4F);
    }
    EXPECT_EQ(found.point_count, count);
    EXPECT_TRUE(found.centroid.isApprox((sum / count).cast<float>(), 1e-4F));
    EXPECT_EQ(std::tie(found.rectangle.left, found.rectangle.top, found.rectangle.right,
                       found.rectangle.bottom),
              std::tie(r.left, r.top, r.right, r.bottom));
    EXPECT_NEAR(found.mean_normal.norm(), 1, 1e-5);
    EXPECT_LT(found.mean_normal.dot(found.centroid), 0);
  }
}

TEST(Segmenter, MeasuresTheTablesPlaneAndTheLowBoxesSize) {
  const LabelledCloud scene = render_touching_boxes();
  Segmenter segmenter;

  const Segmented result = segment(segmenter, scene.view());

  std::map<std::uint16_t, std::map<std::uint32_t, int>> votes;
  for (std::size_t i = 0; i < scene.label.size(); ++i) ++votes[result.labels[i]][scene.label[i]];
  for (const Segment& found : result.segmentation.segments) {
    if (votes[found.label][1] > 1000) {
      EXPECT_GT(found.planarity, 0.98F);
    }
    if (votes[found.label][3] > 1000) {
      // Some points of the other box's edge may be with it.
      EXPECT_NEAR(found.box.extent[0], 0.18F, 0.03F);
      EXPECT_NEAR(found.box.extent[1], 0.15F, 0.02F);
      EXPECT_NEAR(found.box.extent[2], 0.07F, 0.02F);
    }
  }
}

TEST(Segmenter, CallsTheBordersOfBoxesWithTheTableConcave) {
  const LabelledCloud scene = render_touching_boxes();
  Segmenter segmenter;

  const Segmented result = segment(segmenter, scene.view());

  constexpr std::uint16_t table = 1;
  ASSERT_EQ(result.segmentation.borders.size(), 3U);
  for (const Border& border : result.segmentation.borders) {
    EXPECT_LT(border.first, border.second);
    // The boxes touch along a face that is seen at a grazing angle, a few points wide.
    if (border.first == table) {
      EXPECT_EQ(border.kind, BorderKind::concave);
    }
  }
}

TEST(Segmenter, GivesTheSameLabelsAgainAndAfterADifferentCloud) {
  const LabelledCloud scene = render_touching_boxes();
  const LabelledCloud other = render_touching_boxes(200, 100);
  Segmenter segmenter, fresh;

  const auto first = segment(segmenter, scene.view()).labels;
  const auto again = segment(segmenter, scene.view()).labels;
  (void)segment(segmenter, other.view());
  const auto after_other = segment(segmenter, scene.view()).labels;

  EXPECT_EQ(first, again);
  EXPECT_EQ(first, after_other);
  EXPECT_EQ(first, segment(fresh, scene.view()).labels);
}

TEST(Segmenter, TakesPointsWithAStride) {
  const LabelledCloud scene = render_touching_boxes();
  std::vector<float> padded;
  for (std::size_t i = 0; i < scene.label.size(); ++i) {
    padded.insert(padded.end(), {scene.xyz[3 * i], scene.xyz[3 * i + 1], scene.xyz[3 * i + 2], 42});
  }
  Segmenter segmenter;

  const auto packed_labels = segment(segmenter, scene.view()).labels;
  const auto padded_labels =
      segment(segmenter, {padded.data(), 4, scene.width, scene.height}).labels;

  EXPECT_EQ(packed_labels, padded_labels);
}

TEST(Segmenter, SegmentsAnUnorganisedCloud) {
  const LabelledCloud scene = render_touching_boxes();
  const CloudView unorganised{scene.xyz.data(), 3, scene.width * scene.height, 1};
  Segmenter segmenter;

  const Segmented result = segment(segmenter, unorganised);

  ASSERT_EQ(result.outcome, Outcome::segmented);
  ASSERT_EQ(result.segmentation.segments.size(), 3U);
  EXPECT_GT(evaluation::judge(scene.label, result.labels).unweighted_covering, 0.98);
  EXPECT_EQ(result.segmentation.segments[0].rectangle.right, 0U);
}

TEST(Segmenter, SegmentsWithEveryOptionalStepOff) {
  const LabelledCloud scene = render_touching_boxes();
  Segmenter segmenter(thesis());

  const Segmented result = segment(segmenter, scene.view());

  EXPECT_GT(evaluation::judge(scene.label, result.labels).weighted_covering, 0.97);
}

TEST(Segmenter, TellsWhenEachStageEnds) {
  struct Recorder : StageObserver {
    std::vector<Stage> stages;
    void stage_ended(Stage stage) override { stages.push_back(stage); }
  };
  const LabelledCloud scene = render_touching_boxes();
  std::vector<std::uint16_t> labels(scene.label.size());
  Segmentation result;
  Recorder recorder;

  ASSERT_EQ(Segmenter().segment(scene.view(), labels, result, &recorder), Outcome::segmented);

  EXPECT_EQ(recorder.stages,
            (std::vector{Stage::voxelise, Stage::normals, Stage::supervoxels, Stage::graph,
                         Stage::partition, Stage::clean_up, Stage::label_points, Stage::describe}));
}

}  // namespace
}  // namespace cleave::segmentation
