// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/evaluation/partners.hpp"

#include <gtest/gtest.h>

namespace cleave::evaluation {
namespace {

using Truth = std::vector<std::uint32_t>;
using Found = std::vector<std::uint16_t>;

TEST(Partners, AreTheOneToOneAssignmentWithTheMostCommonPoints) {
  // Found 1 shares 3 points with the first and 2 with the second, found 2 shares 2 with the first:
  // 2 + 2 is more than 3.
  const Overlaps overlaps = count_overlaps(Truth{1, 1, 1, 1, 1, 2, 2}, Found{1, 1, 1, 2, 2, 1, 1});

  EXPECT_EQ(partners(overlaps), (std::vector<std::size_t>{1, 0}));
}

TEST(Partners, ShareAPointOrAreNone) {
  const Overlaps overlaps = count_overlaps(Truth{1, 1, 2}, Found{5, 5, 5});

  EXPECT_EQ(partners(overlaps), (std::vector<std::size_t>{0, no_partner}));
  EXPECT_TRUE(partners(count_overlaps(Truth{0}, Found{1})).empty());
  EXPECT_EQ(partners(count_overlaps(Truth{1}, Found{0})), std::vector<std::size_t>{no_partner});
}

TEST(PairLabels, GivesPartnersTheSameNumberAndTheRestOthers) {
  const PairedLabels paired = pair_labels(Truth{40, 40, 40, 70, 70, 0}, Found{9, 9, 3, 8, 8, 8});

  EXPECT_EQ(paired.truth, (Found{1, 1, 1, 2, 2, 0}));
  EXPECT_EQ(paired.found, (Found{1, 1, 3, 2, 2, 2}));
}

TEST(PairLabels, TakesAFoundSegmentOfWhichNothingIsKnownForNone) {
  const PairedLabels paired = pair_labels(Truth{1, 0, 0}, Found{1, 2, 0});

  EXPECT_EQ(paired.found, (Found{1, 0, 0}));
}

}  // namespace
}  // namespace cleave::evaluation
