#include "cleave/cloud/viewpoint.hpp"

#include <gtest/gtest.h>

namespace cleave::client {
namespace {

TEST(Viewpoint, OfAHeaderIsAPose) {
  const auto pose = pose_of_header("100 200 1 0.5 -0.5 0.5 -0.5");

  ASSERT_TRUE(pose.has_value());
  EXPECT_EQ(pose->position_m, (std::array{100.0, 200.0, 1.0}));
  EXPECT_EQ(pose->orientation, (std::array{0.5, -0.5, 0.5, -0.5}));
}

TEST(Viewpoint, ThatEveryoneWritesWhoDoesNotKnowItIsNone) {
  EXPECT_FALSE(pose_of_header("0 0 0 1 0 0 0").has_value());
  EXPECT_FALSE(pose_of_header("0 0 0 0 0 0 0").has_value());
  EXPECT_TRUE(pose_of_header("0 0 0 0 1 0 0").has_value());
}

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
}  // namespace cleave::client
