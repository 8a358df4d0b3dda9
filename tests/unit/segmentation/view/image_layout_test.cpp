// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "recording/pcd/folder.hpp"
#include "stored_scene.hpp"
#include "tests/support/box_scene.hpp"
#include "tests/support/data_folder.hpp"
#include "tests/unit/segmentation/support/depth_scene.hpp"
#include "tests/unit/segmentation/support/segmented.hpp"
#include "workbench/evaluation/labelled_cloud.hpp"

namespace cleave::segmentation {
namespace {

Scene noisy_boxes() {
  const DepthScene scene(1);
  return scene_of(scene.width, scene.height, scene.xyz);
}

Scene touching_boxes() {
  const evaluation::LabelledCloud cloud = tests::render_touching_boxes();
  return scene_of(cloud.width, cloud.height, cloud.xyz);
}

void expect_same_labels_in_all_orders(const Scene& scene) {
  const Segmented upright = segmented(scene.view());
  for (const StorageOrder& order : all_storage_orders()) {
    const Scene other = stored(scene, order);
    const Segmented result = segmented(other.view());
    for (std::size_t i = 0; i < other.index.size(); ++i) {
      ASSERT_EQ(result.labels[i], upright.labels[other.index[i]]) << i;
    }
  }
}

TEST(ImageLayout, OfAnyStorageOrderGetsTheSameLabels) {
  expect_same_labels_in_all_orders(noisy_boxes());
  expect_same_labels_in_all_orders(touching_boxes());
}

TEST(ImageLayout, OfAnyStorageOrderGetsTheSameLabelsInRealScenes) {
  const auto folder = tests::find_data("mosd/learn");
  if (!folder) GTEST_SKIP() << "no recorded scenes; set CLEAVE_DATA";
  constexpr std::size_t every = 9;
  const auto files = recording::pcd_files(*folder);
  for (std::size_t i = 0; i < files.size(); i += every) {
    const evaluation::LabelledCloud cloud = evaluation::load_cloud(files[i]);
    expect_same_labels_in_all_orders(scene_of(cloud.width, cloud.height, cloud.xyz));
  }
}

TEST(ImageLayout, OfAnyStorageOrderGetsRectanglesInItsOwnColumnsAndRows) {
  const Scene scene = touching_boxes();
  for (const StorageOrder& order : all_storage_orders()) {
    const Scene other = stored(scene, order);
    const Segmented result = segmented(other.view());
    std::vector<ImageRectangle> seen(result.segmentation.segments.size(),
                                     {other.width, other.height, 0, 0});
    for (std::uint32_t row = 0; row < other.height; ++row) {
      for (std::uint32_t column = 0; column < other.width; ++column) {
        const std::uint16_t label = result.labels[std::size_t{row} * other.width + column];
        if (label == 0) continue;
        ImageRectangle& r = seen[label - 1U];
        r = {std::min(r.left, column), std::min(r.top, row), std::max(r.right, column + 1),
             std::max(r.bottom, row + 1)};
      }
    }
    for (const Segment& segment : result.segmentation.segments) {
      const ImageRectangle& r = seen[segment.label - 1U];
      EXPECT_EQ(segment.rectangle.left, r.left);
      EXPECT_EQ(segment.rectangle.top, r.top);
      EXPECT_EQ(segment.rectangle.right, r.right);
      EXPECT_EQ(segment.rectangle.bottom, r.bottom);
    }
  }
}

TEST(ImageLayout, InAnotherFrameAndStorageOrderGetsTheSameSegments) {
  for (const Scene& scene : {noisy_boxes(), touching_boxes()}) {
    const Segmented upright = segmented(scene.view());
    for (const StorageOrder& order : all_storage_orders()) {
      const Scene other = stored(moved(scene, camera_on_a_robot()), order);
      EXPECT_GE(agreement(upright.labels, other, segmented(other.view()).labels), 0.995);
    }
  }
}

// `least`: what a coarser or smaller image may differ along borders.
void expect_alike(const Scene& whole, const Scene& part, double least) {
  SCOPED_TRACE(testing::Message() << part.width << " x " << part.height);
  const Segmented result = segmented(whole.view());
  EXPECT_GE(agreement(result.labels, part, segmented(part.view()).labels), least);
  const Scene on_robot = moved(part, camera_on_a_robot());
  EXPECT_GE(agreement(result.labels, on_robot, segmented(on_robot.view()).labels), least);
}

TEST(ImageLayout, MayLackColumnsAndRows) {
  const Scene scene = touching_boxes();
  const auto all = [](std::uint32_t) { return true; };
  const auto even = [](std::uint32_t i) { return i % 2 == 0; };
  const auto not_middle = [](std::uint32_t i) { return i < 130 || i >= 136; };
  const auto not_seventh = [](std::uint32_t i) { return i % 7 != 0; };

  expect_alike(scene, chosen(scene, even, even), 0.97);
  expect_alike(scene, chosen(scene, all, even), 0.97);
  expect_alike(scene, chosen(scene, even, all), 0.97);
  expect_alike(scene, chosen(scene, not_middle, all), 0.97);
  expect_alike(scene, chosen(scene, all, not_middle), 0.97);
  expect_alike(scene, chosen(scene, not_seventh, not_seventh), 0.97);
}

TEST(ImageLayout, MayBeCroppedAnywhere) {
  const Scene scene = touching_boxes();
  const auto left = [](std::uint32_t i) { return i < 180; };
  const auto right = [](std::uint32_t i) { return i >= 130; };
  const auto top = [](std::uint32_t i) { return i < 140; };
  const auto bottom = [](std::uint32_t i) { return i >= 90; };

  expect_alike(scene, chosen(scene, left, top), 0.97);
  expect_alike(scene, chosen(scene, right, top), 0.97);
  expect_alike(scene, chosen(scene, left, bottom), 0.97);
  expect_alike(scene, chosen(scene, right, bottom), 0.97);
}

}  // namespace
}  // namespace cleave::segmentation
