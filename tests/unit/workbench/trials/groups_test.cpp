// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/trials/groups.hpp"

#include <gtest/gtest.h>

namespace cleave::workbench {
namespace {

TEST(Groups, AreRangesWithBothEndsOrSingleScenes) {
  const auto groups = parse_groups("0-15,16-23,30", 31);

  ASSERT_EQ(groups.size(), 3U);
  EXPECT_EQ(groups[0].first, 0U);
  EXPECT_EQ(groups[0].last, 15U);
  EXPECT_EQ(groups[2].first, 30U);
  EXPECT_EQ(groups[2].last, 30U);
  EXPECT_EQ(groups[1].name(), "16-23");
  EXPECT_EQ(groups[2].name(), "30");
}

TEST(Groups, AreNoneWhereNoneWereAskedFor) {
  EXPECT_TRUE(parse_groups("", 5).empty());
}

TEST(Groups, OfScenesThatAreNotThereAreRefused) {
  EXPECT_THROW((void)parse_groups("0-5", 5), GroupError);
}

TEST(Groups, ThatAreNoRangesAreRefused) {
  for (const char* text : {"a", "3-1", "1-", "-1", "1,,2", "1-2-3", "0 - 3", ",1"}) {
    EXPECT_THROW((void)parse_groups(text, 10), GroupError) << text;
  }
}

}  // namespace
}  // namespace cleave::workbench
