// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/clean_up/border_joining.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cleave::segmentation {
namespace {

using Segments = std::vector<std::uint32_t>;

// Patches of a strip along x at 1 m, 25 mm from one to the next, each turned from the last by so
// many radians (positive: convex), with an edge from each to the next.
struct Strip {
  std::vector<Surfel> patches;
  std::vector<SupervoxelEdge> edges;

  explicit Strip(const std::vector<float>& bends_rad) {
    float angle_rad = 0;
    for (const float bend : bends_rad) angle_rad -= bend / 2;  // faces the sensor in the middle
    Eigen::Vector3f position(0, 0, 1);
    patches.push_back({position, {std::sin(angle_rad), 0, -std::cos(angle_rad)}});
    for (const float bend : bends_rad) {
      const float middle_rad = angle_rad + bend / 2;
      angle_rad += bend;
      position += 0.025F * Eigen::Vector3f(std::cos(middle_rad), 0, std::sin(middle_rad));
      patches.push_back({position, {std::sin(angle_rad), 0, -std::cos(angle_rad)}});
      const auto last = static_cast<std::uint32_t>(patches.size() - 1);
      edges.push_back({.first = last - 1,
                       .second = last,
                       .touching_voxels = 5,
                       .weight = bend < 0 ? 0.1F : 1.0F,
                       .convex = bend > 0,
                       .valid = true});
    }
  }

  Segments join(Segments segment) const {
    BorderJoiner().join(edges, patches, {}, 2, segment);
    return segment;
  }
};

TEST(BorderJoiner, JoinsWhatNoCutOfItsOwnWouldPart) {
  Strip floor({0, 0, 0});
  EXPECT_EQ(floor.join({0, 0, 1, 1}), (Segments{0, 0, 0, 0}));

  floor.edges[1].cannot_link_share = 0.5F;
  EXPECT_EQ(floor.join({0, 0, 1, 1}), (Segments{0, 0, 1, 1})) << "utility 0.5";
}

TEST(BorderJoiner, JoinsHollowsThatBendAtTheirBorderAsInside) {
  Strip bowl({-0.3F, -0.3F, -0.4F, -0.3F, -0.3F});
  bowl.edges[2].cannot_link_share = 0.3F;

  EXPECT_EQ(bowl.join({0, 0, 0, 1, 1, 1}), (Segments{0, 0, 0, 0, 0, 0}));
}

TEST(BorderJoiner, KeepsFlatAndRoundBodiesThatTouchApart) {
  Strip faces({0, 0, -0.4F, 0, 0});
  Strip rolls({0.3F, 0.3F, -0.4F, 0.3F, 0.3F});
  for (Strip* strip : {&faces, &rolls}) strip->edges[2].cannot_link_share = 0.3F;

  EXPECT_EQ(faces.join({0, 0, 0, 1, 1, 1}), (Segments{0, 0, 0, 1, 1, 1}));
  EXPECT_EQ(rolls.join({0, 0, 0, 1, 1, 1}), (Segments{0, 0, 0, 1, 1, 1}));
}

TEST(BorderJoiner, KeepsHollowsApartAtASharpCrease) {
  Strip bowls({-0.3F, -0.3F, -1.4F, -0.3F, -0.3F});
  bowls.edges[2].cannot_link_share = 1;

  EXPECT_EQ(bowls.join({0, 0, 0, 1, 1, 1}), (Segments{0, 0, 0, 1, 1, 1}));
}

TEST(BorderJoiner, JoinsAcrossALongConvexBorderWithoutAValidEdge) {
  Strip roof({0, 0.6F, 0});
  roof.edges[1].valid = false;
  roof.edges[1].touching_voxels = 9;
  EXPECT_EQ(roof.join({0, 0, 1, 1}), (Segments{0, 0, 0, 0}));

  roof.edges[1].touching_voxels = 3;
  EXPECT_EQ(roof.join({0, 0, 1, 1}), (Segments{0, 0, 1, 1})) << "they may touch by chance";

  roof.edges[1].touching_voxels = 9;
  for (std::size_t p = 2; p < 4; ++p) roof.patches[p].position.z() += 0.04F;
  EXPECT_EQ(roof.join({0, 0, 1, 1}), (Segments{0, 0, 1, 1})) << "one is behind the other";
}

TEST(BorderJoiner, KeepsTheLowestNumberOfAChain) {
  const Strip floor({0, 0, 0});
  Segments segment = {2, 1, 3, 0};

  BorderJoiner().join(floor.edges, floor.patches, {}, 4, segment);

  EXPECT_EQ(segment, (Segments{0, 0, 0, 0}));
}

}  // namespace
}  // namespace cleave::segmentation
