// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/unit/segmentation/support/depth_scene.hpp"
#include "tests/unit/segmentation/support/segmented.hpp"

namespace cleave::segmentation {
namespace {

Segmenter segmenter_for(Representation representation) {
  Options options;
  options.representation = representation;
  return Segmenter(options);
}

TEST(CellPath, IsNotTakenForCloudsFromSeveralViewpoints) {
  const DepthScene scene(11);
  Options options;
  options.voxel.viewpoint = Viewpoint::multiple;
  Segmenter cells(options);
  options.representation = Representation::voxels;
  Segmenter voxels(options);

  EXPECT_EQ(segmented(cells, scene.view()).labels, segmented(voxels, scene.view()).labels);
}

TEST(CellPath, LeavesOtherCloudsToTheVoxels) {
  DepthScene scene(12);
  // Seen in parallel rays, as no camera does.
  for (std::size_t pixel = 0; pixel < scene.xyz.size() / 3; ++pixel) {
    scene.xyz[3 * pixel] = 0.002F * static_cast<float>(pixel % scene.width);
    scene.xyz[3 * pixel + 1] = 0.002F * static_cast<float>(pixel / scene.width);
  }
  Segmenter cells = segmenter_for(Representation::cells);
  Segmenter voxels = segmenter_for(Representation::voxels);

  EXPECT_EQ(segmented(cells, scene.view()).labels, segmented(voxels, scene.view()).labels);
}

TEST(CellPath, RemembersNothingOfFramesBefore) {
  const DepthScene scene(13);
  DepthScene narrow(14);
  narrow.height = 60;
  narrow.xyz.resize(std::size_t{3} * narrow.width * narrow.height);
  Segmenter segmenter = segmenter_for(Representation::cells);

  const auto first = segmented(segmenter, scene.view()).labels;
  (void)segmented(segmenter, narrow.view()).labels;

  EXPECT_EQ(segmented(segmenter, scene.view()).labels, first);
}

TEST(CellPath, LabelsExactlyWhatWasMeasured) {
  const DepthScene scene(15);
  Segmenter segmenter = segmenter_for(Representation::cells);

  const auto labels = segmented(segmenter, scene.view()).labels;

  for (std::size_t i = 0; i < labels.size(); ++i) {
    EXPECT_EQ(labels[i] != 0, std::isfinite(scene.view().point(i)[2]));
  }
}

TEST(CellPath, SeparatesTheFacesOfABoxFromTheTable) {
  const DepthScene scene(16);
  Segmenter segmenter = segmenter_for(Representation::cells);

  const auto labels = segmented(segmenter, scene.view()).labels;

  const auto at = [&](std::size_t column, std::size_t row) {
    return labels[row * scene.width + column];
  };
  EXPECT_NE(at(10, 100), at(65, 70));
}

}  // namespace
}  // namespace cleave::segmentation
