// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "segmentation/view/measured.hpp"
#include "tests/support/box_scene.hpp"
#include "tests/unit/segmentation/support/segment_cloud.hpp"

namespace cleave::segmentation {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float denormal = std::numeric_limits<float>::denorm_min();

Segmented segment(const std::vector<float>& xyz, std::uint32_t width, std::uint32_t height,
                  const Options& options = {}) {
  Segmenter segmenter(options);
  return segment(segmenter, {xyz.data(), 3, width, height});
}

// Points too few for a segment have no label, even if they are measured: so many in all.
void expect_only_measured_points_labelled(const std::vector<float>& xyz, const Segmented& result,
                                          std::size_t dust = 0) {
  ASSERT_EQ(result.outcome, Outcome::segmented);
  std::size_t measured = 0;
  std::size_t counted = 0;
  for (std::size_t i = 0; i < result.labels.size(); ++i) {
    const bool is_point = is_measured(&xyz[3 * i]);
    EXPECT_TRUE(is_point || result.labels[i] == 0) << "point " << i;
    measured += is_point ? 1 : 0;
    counted += result.labels[i] > 0 ? 1 : 0;
  }
  EXPECT_LE(measured - counted, dust);
  EXPECT_EQ(result.segmentation.measured_points, measured);
  for (const Segment& s : result.segmentation.segments) {
    counted -= s.point_count;
    EXPECT_TRUE(s.centroid.allFinite() && s.box.centre.allFinite() && s.box.extent.allFinite());
    EXPECT_NEAR(s.mean_normal.norm(), 1, 1e-4);
    EXPECT_NEAR(s.box.orientation.norm(), 1, 1e-4);
  }
  EXPECT_EQ(counted, 0U);
}

TEST(SegmenterOnDegenerateClouds, RefusesAnEmptyOne) {
  const Segmented result = segment({}, 0, 0);

  EXPECT_EQ(result.outcome, Outcome::no_finite_point);
  EXPECT_TRUE(result.segmentation.segments.empty());
}

TEST(SegmenterOnDegenerateClouds, RefusesOneWithoutAFinitePoint) {
  const Segmented result =
      segment({nan, nan, nan, 0, infinity, 1, 0, 0, -infinity, 1, nan, 1}, 2, 2);

  EXPECT_EQ(result.outcome, Outcome::no_finite_point);
  EXPECT_EQ(result.labels, std::vector<std::uint16_t>(4, 0));
}

TEST(SegmenterOnDegenerateClouds, RefusesSizesThatDisagree) {
  const std::vector<float> xyz(12, 1);
  std::vector<std::uint16_t> labels(3, 77);
  Segmentation result;

  EXPECT_EQ(Segmenter().segment({xyz.data(), 3, 2, 2}, labels, result), Outcome::bad_size);
  EXPECT_EQ(labels, std::vector<std::uint16_t>(3, 0));
  labels.resize(4);
  EXPECT_EQ(Segmenter().segment({nullptr, 3, 2, 2}, labels, result), Outcome::bad_size);
  EXPECT_EQ(Segmenter().segment({xyz.data(), 2, 2, 2}, labels, result), Outcome::bad_size);
}

TEST(SegmenterOnDegenerateClouds, LabelsASinglePoint) {
  const Segmented result = segment({0.1F, 0.2F, 1}, 1, 1);

  ASSERT_EQ(result.outcome, Outcome::segmented);
  EXPECT_EQ(result.labels, std::vector<std::uint16_t>{1});
  ASSERT_EQ(result.segmentation.segments.size(), 1U);
  EXPECT_EQ(result.segmentation.segments[0].point_count, 1U);
}

TEST(SegmenterOnDegenerateClouds, SeparatesTwoPointsThatAreFarApart) {
  const Segmented result = segment({0, 0, 1, 5, 0, 1}, 2, 1);

  EXPECT_EQ(result.labels, (std::vector<std::uint16_t>{1, 2}));
}

TEST(SegmenterOnDegenerateClouds, MakesIdenticalPointsOneSegment) {
  std::vector<float> xyz;
  for (int i = 0; i < 300; ++i) xyz.insert(xyz.end(), {0.5F, -0.5F, 2});

  const Segmented result = segment(xyz, 20, 15);

  expect_only_measured_points_labelled(xyz, result);
  EXPECT_EQ(result.segmentation.segments.size(), 1U);
}

TEST(SegmenterOnDegenerateClouds, TakesPointsAtAndBehindTheSensor) {
  std::vector<float> xyz = {0, 0, 0};
  for (int i = 0; i < 400; ++i) {
    xyz.insert(xyz.end(),
               {0.01F * static_cast<float>(i % 20), 0.01F * static_cast<float>(i / 20), -1});
  }
  Options single;
  single.voxel.viewpoint = Viewpoint::single;

  expect_only_measured_points_labelled(xyz, segment(xyz, 401, 1), 1);
  expect_only_measured_points_labelled(xyz, segment(xyz, 401, 1, single), 401);
}

TEST(SegmenterOnDegenerateClouds, TakesHugeAndDenormalCoordinates) {
  std::vector<float> xyz;
  for (const float x : {-1e30F, -1.0F, -denormal, 0.0F, denormal, 1.0F, 1e30F, 3.4e38F}) {
    for (const float y : {-3.4e38F, 0.0F, denormal, 1e30F}) {
      for (const float z : {denormal, 1e-20F, 1.0F, 1e30F, 3.4e38F})
        xyz.insert(xyz.end(), {x, y, z});
    }
  }
  for (const Viewpoint viewpoint : {Viewpoint::automatic, Viewpoint::multiple}) {
    for (Options options : {Options{}, thesis()}) {
      options.voxel.viewpoint = viewpoint;
      expect_only_measured_points_labelled(xyz, segment(xyz, 16, 10, options), 160);
    }
  }
}

TEST(SegmenterOnDegenerateClouds, IsNotDisturbedByOneFarPoint) {
  const evaluation::LabelledCloud scene = tests::render_touching_boxes();
  auto with_far_point = scene.xyz;
  std::fill_n(with_far_point.begin(), 3, 1e30F);  // the first point was NaN

  const auto labels = segment(scene.xyz, scene.width, scene.height).labels;
  const auto disturbed = segment(with_far_point, scene.width, scene.height).labels;

  EXPECT_EQ(labels, disturbed);
}

TEST(SegmenterOnDegenerateClouds, LabelsNoiseWithoutAnySurface) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(0, 0.3F);
  std::vector<float> xyz;
  for (int i = 0; i < 20000; ++i) {
    xyz.insert(xyz.end(), {uniform(random), uniform(random), 0.5F + uniform(random)});
  }

  for (const Options& options : {Options{}, thesis()}) {
    expect_only_measured_points_labelled(xyz, segment(xyz, 200, 100, options), 200);
  }
}

TEST(SegmenterOnDegenerateClouds, RefusesMoreSegmentsThanLabelsCanName) {
  Options options;
  options.voxel.follow_spacing = false;
  options.clean_up.min_segment_points = 0;
  const auto scattered = [&options](int points) {
    std::vector<float> xyz;
    for (int i = 0; i < points; ++i) {
      xyz.insert(xyz.end(), {static_cast<float>(i % 300), static_cast<float>(i / 300), -1});
    }
    return segment(xyz, static_cast<std::uint32_t>(points), 1, options);
  };

  const Segmented most = scattered(65535);
  const Segmented too_many = scattered(65536);

  EXPECT_EQ(most.outcome, Outcome::segmented);
  EXPECT_EQ(most.segmentation.segments.size(), 65535U);
  EXPECT_EQ(too_many.outcome, Outcome::too_many_segments);
  EXPECT_EQ(too_many.labels, std::vector<std::uint16_t>(65536, 0));
  EXPECT_TRUE(too_many.segmentation.segments.empty());
}

}  // namespace
}  // namespace cleave::segmentation
