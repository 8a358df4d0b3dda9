// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/cloud/viewpoint.hpp"

#include <gtest/gtest.h>

namespace cleave::workbench {
namespace {

TEST(Viewpoint, MayBeGivenAsAPositionAlone) {
  const segmentation::SensorPose pose = parse_viewpoint("1.5,-2,0");

  EXPECT_EQ(pose.position_m, (std::array{1.5, -2.0, 0.0}));
  EXPECT_EQ(pose.orientation, (std::array{1.0, 0.0, 0.0, 0.0}));
  EXPECT_EQ(parse_viewpoint("0,0,0,0,0,1,0").orientation, (std::array{0.0, 0.0, 1.0, 0.0}));
}

TEST(Viewpoint, IsRefusedWithWhatWasExpected) {
  for (const char* text : {"", "1", "1,2", "1,2,x", "1,2,3,", "1,2,3,4", "nan,0,0", "1e999,0,0",
                           "1,2,3,0,0,0,0", "1, 2, 3"}) {
    EXPECT_THROW((void)parse_viewpoint(text), ViewpointError) << text;
  }
}

}  // namespace
}  // namespace cleave::workbench
