// SPDX-License-Identifier: BSD-3-Clause
#include "recording/frames/gap_limit.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "recording/time_units.hpp"

namespace cleave::recording {
namespace {

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;

constexpr std::int64_t s_ns = 1'000'000'000;
constexpr std::int64_t day_ns = 86'400 * s_ns;

TEST(GapLimit, KeepsAPauseThatIsShorter) {
  const GapLimit gaps(2);
  EXPECT_EQ(gaps.between(10 * s_ns, 10 * s_ns + 33'000'000).wait, 33ms);
  EXPECT_EQ(gaps.between(10 * s_ns, 12 * s_ns).wait, 2s);
  EXPECT_FALSE(gaps.between(10 * s_ns, 12 * s_ns).is_jump);
}

TEST(GapLimit, ShortensWhatIsLonger) {
  const GapLimit::Gap gap = GapLimit(1).between(0, 11 * day_ns);
  EXPECT_EQ(gap.wait, 1s);
  EXPECT_TRUE(gap.is_jump);
}

TEST(SecondsBetween, AreThoseOfAnyTwoTimes) {
  constexpr std::int64_t first = std::numeric_limits<std::int64_t>::min();
  constexpr std::int64_t last = std::numeric_limits<std::int64_t>::max();
  EXPECT_DOUBLE_EQ(seconds_between(s_ns, 3 * s_ns), 2);
  EXPECT_DOUBLE_EQ(seconds_between(3 * s_ns, s_ns), -2);
  EXPECT_DOUBLE_EQ(seconds_between(first, last), 0x1p64 / 1e9);
  EXPECT_DOUBLE_EQ(seconds_between(last, first), -0x1p64 / 1e9);
}

TEST(GapLimit, WaitsForNothingWhenTimeGoesBack) {
  const GapLimit::Gap gap = GapLimit(1).between(11 * day_ns, 0);
  EXPECT_EQ(gap.wait, 0s);
  EXPECT_TRUE(gap.is_jump);
}

TEST(GapLimit, TakesAnyTwoTimes) {
  constexpr std::int64_t first = std::numeric_limits<std::int64_t>::min();
  constexpr std::int64_t last = std::numeric_limits<std::int64_t>::max();
  EXPECT_EQ(GapLimit(1).between(first, last).wait, 1s);
  EXPECT_EQ(GapLimit(1).between(last, first).wait, 0s);
  EXPECT_EQ(GapLimit(0).between(0, 1).wait, 0s);
}

TEST(GapLimit, NamesTheJump) {
  const std::string on = GapLimit(1).text_of_jump(0, 11 * day_ns);
  EXPECT_NE(on.find("goes on by 11 days"), std::string::npos) << on;
  EXPECT_NE(on.find("after 1 s"), std::string::npos) << on;
  const std::string back = GapLimit(1).text_of_jump(2 * s_ns, 0);
  EXPECT_NE(back.find("goes back by 2 s"), std::string::npos) << back;
}

}  // namespace
}  // namespace cleave::recording
