// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/cloud/option_setter.hpp"

#include <gtest/gtest.h>

namespace cleave::workbench {
namespace {

std::string refusal_of(const std::string& assignment) {
  segmentation::Options options;
  try {
    set_option(options, assignment);
  } catch (const OptionError& error) {
    return error.what();
  }
  return {};
}

TEST(OptionSetter, SetsEachKindOfOption) {
  segmentation::Options options;
  set_option(options, "voxel.size_m=0.005");
  set_option(options, "clean_up.min_segment_points=17");
  set_option(options, "refine.boundary=false");
  set_option(options, "voxel.viewpoint=multiple");
  EXPECT_EQ(options.voxel.size_m, 0.005F);
  EXPECT_EQ(options.clean_up.min_segment_points, 17U);
  EXPECT_FALSE(options.refine.boundary);
  EXPECT_EQ(options.voxel.viewpoint, segmentation::Viewpoint::multiple);
}

TEST(OptionSetter, NamesTheKnownKeysForAnUnknownOne) {
  const std::string refusal = refusal_of("voxel.size=1");
  EXPECT_NE(refusal.find("no option 'voxel.size'"), std::string::npos);
  EXPECT_NE(refusal.find("voxel.size_m"), std::string::npos);
  EXPECT_NE(refusal.find("describe.plane_distance_m"), std::string::npos);
}

TEST(OptionSetter, SaysWhatItExpected) {
  for (const char* assignment : {"voxel.size_m=fast", "voxel.size_m=-1", "voxel.size_m=nan",
                                 "voxel.size_m=", "clean_up.min_segment_points=1.5",
                                 "refine.boundary=maybe", "algorithm=magic"}) {
    EXPECT_NE(refusal_of(assignment).find("expected"), std::string::npos) << assignment;
  }
  EXPECT_NE(refusal_of("voxel.size_m").find("KEY=VALUE"), std::string::npos);
}

TEST(OptionSetter, ListsEveryOptionWithItsDefault) {
  EXPECT_NE(list_options().find("supervoxel.seed_spacing_m"), std::string::npos);
  EXPECT_NE(list_options().find("0.025"), std::string::npos);
}

}  // namespace
}  // namespace cleave::workbench
