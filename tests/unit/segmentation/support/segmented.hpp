// SPDX-License-Identifier: BSD-3-Clause
// Segments a cloud that can be segmented; a test in which it is refused fails.
#pragma once

#include <gtest/gtest.h>

#include "tests/unit/segmentation/support/segment_cloud.hpp"

namespace cleave::segmentation {

inline Segmented segmented(Segmenter& segmenter, const CloudView& cloud) {
  Segmented result = segment(segmenter, cloud);
  EXPECT_EQ(result.outcome, Outcome::segmented);
  return result;
}

inline Segmented segmented(const CloudView& cloud, const Options& options = {}) {
  Segmenter segmenter(options);
  return segmented(segmenter, cloud);
}

}  // namespace cleave::segmentation
