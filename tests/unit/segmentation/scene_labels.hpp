#pragma once

#include <gtest/gtest.h>

#include "depth_scene.hpp"
#include "segmentation/segmenter.hpp"

namespace cleave::segmentation {

inline std::vector<std::uint16_t> labels_of(Segmenter& segmenter, const DepthScene& scene) {
  std::vector<std::uint16_t> labels(scene.view().size());
  Segmentation result;
  EXPECT_EQ(segmenter.segment(scene.view(), labels, result), Outcome::segmented);
  return labels;
}

}  // namespace cleave::segmentation
