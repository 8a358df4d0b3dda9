// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "segmentation/result_check.hpp"
#include "segmentation/spacing/spacing_options.hpp"
#include "segmentation/voxels/voxel_fitter.hpp"
#include "segmentation/voxels/voxel_neighbours.hpp"
#include "tests/unit/segmentation/support/segmented.hpp"
#include "tests/unit/segmentation/support/table_cloud.hpp"

namespace cleave::segmentation {
namespace {

Options metric() {
  Options options;
  options.voxel.viewpoint = Viewpoint::multiple;
  return options;
}

float growth_of(const CloudView& cloud, const VoxelOptions& options) {
  PointSet points;
  gather_measured_points(cloud, points);
  VoxelGrid grid;
  NeighbourLists neighbours;
  return VoxelFitter().voxelise(points, options, grid, neighbours);
}

class Spacing : public testing::TestWithParam<float> {};

TEST_P(Spacing, OfACloudSetsTheSizeOfVoxels) {
  const float size_m =
      VoxelOptions{}.size_m * growth_of(TableCloud(GetParam()).view(), metric().voxel);

  EXPECT_GE(size_m, 1.0F * GetParam());
  EXPECT_LE(size_m, 2.2F * GetParam());
}

TEST_P(Spacing, DoesNotKeepTheTableAndItsBoxesFromBeingFound) {
  const Segmentation result = segmented(TableCloud(GetParam()).view(), metric()).segmentation;

  EXPECT_EQ(result.segments.size(), 4U);
  EXPECT_EQ(doubt_about(result), Doubt::none);
}

INSTANTIATE_TEST_SUITE_P(OfFilteredTablesAndTerrain, Spacing,
                         testing::Values(0.007F, 0.01F, 0.02F, 0.05F, 0.3F, 1.0F));

TEST(VoxelFitter, KeepsTheSizeOfADenseCloud) {
  EXPECT_EQ(growth_of(TableCloud(0.002F).view(), metric().voxel), 1);
}

TEST(VoxelFitter, KeepsASizeThatIsNotTheDefaultAndAnyIfItMayNotFollow) {
  const TableCloud table(0.05F);
  VoxelOptions chosen = metric().voxel;
  chosen.size_m = 0.01F;
  VoxelOptions fixed = metric().voxel;
  fixed.follow_spacing = false;

  EXPECT_EQ(growth_of(table.view(), chosen), 1);
  EXPECT_EQ(growth_of(table.view(), fixed), 1);
}

TEST(VoxelFitter, KeepsTheSizeWherePointsMakeNoSurface) {
  std::vector<float> line;
  for (int i = 0; i < 1000; ++i) line.insert(line.end(), {static_cast<float>(i), 1, 1});

  EXPECT_EQ(growth_of({line.data(), 3, 1000, 1}, metric().voxel), 1);
}

// Growth is a power of 2 where the last step of the search was one too many, or that by the root.
bool is_power_of_two(float growth) {
  int exponent = 0;
  return std::frexp(growth, &exponent) == 0.5F;
}

class FittedNeighbours : public testing::TestWithParam<Neighbourhood> {};

TEST_P(FittedNeighbours, AreThoseThatWereAskedForWhateverTheSizeOfVoxels) {
  std::set<bool> met;
  for (const float spacing : {0.002F, 0.007F, 0.01F, 0.02F, 0.05F, 0.3F}) {
    for (const bool follows : {true, false}) {
      VoxelOptions options = metric().voxel;
      options.neighbourhood = GetParam();
      options.follow_spacing = follows;
      PointSet points;
      gather_measured_points(TableCloud(spacing).view(), points);
      VoxelGrid grid;
      NeighbourLists neighbours, expected;

      const float growth = VoxelFitter().voxelise(points, options, grid, neighbours);

      find_voxel_neighbours(grid, GetParam(), expected);
      EXPECT_EQ(neighbours.begin, expected.begin) << spacing;
      EXPECT_EQ(neighbours.neighbour, expected.neighbour) << spacing;
      if (growth > 1) met.insert(is_power_of_two(growth));
    }
  }
  EXPECT_EQ(met.size(), 2U) << "a spacing for either end of the search";
}

INSTANTIATE_TEST_SUITE_P(OfEveryKind, FittedNeighbours,
                         testing::Values(Neighbourhood::automatic, Neighbourhood::faces,
                                         Neighbourhood::edges, Neighbourhood::corners));

TEST(OptionsForSpacing, GrowSeedsWithVoxelsAndShrinkWhatIsSmall) {
  const CloudSpacing sparse{.points = 16000, .points_a_cell = 2.5, .growth = 2};

  const Options options = options_for_spacing({}, sparse);

  EXPECT_FLOAT_EQ(options.supervoxel.seed_spacing_m, 0.05F);
  EXPECT_EQ(options.clean_up.min_segment_points, 45U) << "18 voxels";
  EXPECT_EQ(options.clean_up.weak_border_points, 155U);
}

TEST(OptionsForSpacing, LeaveDenseCloudsAndChosenValuesAlone) {
  const CloudSpacing dense{.points = 300000, .points_a_cell = 9, .growth = 1};
  const CloudSpacing sparse{.points = 16000, .points_a_cell = 2.5, .growth = 2};
  Options chosen;
  chosen.supervoxel.seed_spacing_m = 0.03F;
  chosen.clean_up.min_segment_points = 200;
  Options fixed;
  fixed.voxel.follow_spacing = false;

  EXPECT_EQ(options_for_spacing({}, dense).clean_up.min_segment_points, 145U);
  EXPECT_EQ(options_for_spacing(chosen, sparse).supervoxel.seed_spacing_m, 0.03F);
  EXPECT_EQ(options_for_spacing(chosen, sparse).clean_up.min_segment_points, 200U);
  EXPECT_EQ(options_for_spacing(fixed, sparse).clean_up.min_segment_points, 145U);
}

TEST(OptionsForSpacing, FindSegmentsInACloudOfAHundredPoints) {
  const CloudSpacing few{.points = 100, .points_a_cell = 1, .growth = 1};

  EXPECT_EQ(options_for_spacing({}, few).clean_up.min_segment_points, 2U);
}

TEST(Doubt, IsCastOnSegmentsOfSinglePointsAndOnPointsWithoutSegments) {
  const auto result = [](std::uint32_t measured, std::vector<std::uint32_t> counts) {
    Segmentation segmentation;
    segmentation.measured_points = measured;
    for (const std::uint32_t count : counts) {
      segmentation.segments.emplace_back();
      segmentation.segments.back().point_count = count;
    }
    return segmentation;
  };

  EXPECT_EQ(doubt_about(result(1000, {900, 90})), Doubt::none);
  EXPECT_EQ(doubt_about(result(1000, {998, 1, 1})), Doubt::mostly_single_points);
  EXPECT_EQ(doubt_about(result(1000, {400})), Doubt::mostly_unlabelled);
  EXPECT_EQ(doubt_about(result(1000, {})), Doubt::mostly_unlabelled);
  EXPECT_NE(advice_on(Doubt::mostly_single_points).find("voxel.size_m"), std::string_view::npos);
  EXPECT_EQ(advice_on(Doubt::none), "");
}

}  // namespace
}  // namespace cleave::segmentation
