// SPDX-License-Identifier: BSD-3-Clause
#include "config/closest.hpp"

#include <gtest/gtest.h>

namespace cleave::config {
namespace {

TEST(Closest, FindsTheWordThatASlipOfTheFingerMissed) {
  EXPECT_EQ(closest("wrokers", {"sensors", "workers", "queue"}), "workers");
  EXPECT_EQ(closest("quee", {"sensors", "workers", "queue"}), "queue");
}

TEST(Closest, SuggestsNothingForAnUnrelatedWord) {
  EXPECT_EQ(closest("temperature", {"sensors", "workers", "queue"}), "");
  EXPECT_EQ(closest("ab", {"fps"}), "");
}

TEST(Closest, TakesTheFirstOfEquallyCloseWords) {
  EXPECT_EQ(closest("loap", {"loop", "leap"}), "loop");
}

}  // namespace
}  // namespace cleave::config
