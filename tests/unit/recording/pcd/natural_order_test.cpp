// SPDX-License-Identifier: BSD-3-Clause
#include "recording/pcd/natural_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace cleave::recording {
namespace {

std::vector<std::string> sorted(std::vector<std::string> names) {
  std::sort(names.begin(), names.end(), natural_less);
  return names;
}

TEST(NaturalOrder, ComparesNumbersByValue) {
  EXPECT_EQ(sorted({"learn10.pcd", "learn9.pcd", "learn1.pcd", "learn2.pcd"}),
            (std::vector<std::string>{"learn1.pcd", "learn2.pcd", "learn9.pcd", "learn10.pcd"}));
}

TEST(NaturalOrder, ComparesSeveralNumbersInAName) {
  EXPECT_TRUE(natural_less("a2b10", "a2b11"));
  EXPECT_TRUE(natural_less("a2b10", "a10b1"));
}

TEST(NaturalOrder, TakesNumbersOfAnyLength) {
  EXPECT_TRUE(natural_less("99999999999999999999", "100000000000000000000"));
}

TEST(NaturalOrder, IsTotalForLeadingZeros) {
  EXPECT_TRUE(natural_less("a01", "a1"));
  EXPECT_FALSE(natural_less("a1", "a01"));
  EXPECT_TRUE(natural_less("a01", "a2"));
}

TEST(NaturalOrder, PutsAPrefixFirstAndNothingBeforeItself) {
  EXPECT_TRUE(natural_less("", "a"));
  EXPECT_TRUE(natural_less("scene", "scene1"));
  EXPECT_FALSE(natural_less("scene1", "scene1"));
}

TEST(NaturalOrder, IsAStrictOrderOfAllTexts) {
  std::mt19937 random(7);
  std::vector<std::string> texts;
  for (int i = 0; i < 60; ++i) {
    std::string text;
    for (std::size_t n = random() % 5; n > 0; --n) text += "0012ab"[random() % 6];
    texts.push_back(text);
  }
  for (const auto& a : texts) {
    for (const auto& b : texts) {
      EXPECT_EQ(int{natural_less(a, b)} + int{natural_less(b, a)}, a == b ? 0 : 1) << a << ' ' << b;
      for (const auto& c : texts) {
        if (natural_less(a, b) && natural_less(b, c)) {
          EXPECT_TRUE(natural_less(a, c)) << a << ' ' << b << ' ' << c;
        }
      }
    }
  }
}

TEST(NaturalOrder, PutsLettersBeyondAsciiBehindTheOthers) {
  EXPECT_TRUE(natural_less("z", "\xC3\xA4"));
  EXPECT_FALSE(natural_less("\xC3\xA4", "z"));
}

}  // namespace
}  // namespace cleave::recording
