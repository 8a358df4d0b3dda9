#include "sensor/natural_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace cleave::sensor {
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

}  // namespace
}  // namespace cleave::sensor
