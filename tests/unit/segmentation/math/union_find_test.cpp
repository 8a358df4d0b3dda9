// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/math/union_find.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace cleave::segmentation {
namespace {

// The slow way: everyone carries the lowest member of its set, and a join rewrites all.
class RelabelledSets {
 public:
  explicit RelabelledSets(std::uint32_t size) : root_(size) {
    std::iota(root_.begin(), root_.end(), 0U);
  }
  void join(std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax({root_[a], root_[b]});
    std::ranges::replace(root_, high, low);
  }
  [[nodiscard]] std::uint32_t root(std::uint32_t member) const { return root_[member]; }

 private:
  std::vector<std::uint32_t> root_;
};

TEST(UnionFind, HoldsEachNumberAloneUntilItIsJoined) {
  UnionFind sets;
  sets.reset(3);

  for (std::uint32_t member = 0; member < 3; ++member) EXPECT_EQ(sets.root(member), member);
  EXPECT_EQ(sets.size(), 3U);
}

TEST(UnionFind, NamesASetByItsLowestMemberInWhateverOrderItWasJoined) {
  std::array<std::pair<std::uint32_t, std::uint32_t>, 3> joins = {{{5, 3}, {7, 5}, {7, 1}}};
  std::sort(joins.begin(), joins.end());
  do {
    UnionFind sets;
    sets.reset(8);
    for (const auto& [a, b] : joins) sets.join(a, b);

    for (const std::uint32_t member : {1U, 3U, 5U, 7U}) EXPECT_EQ(sets.root(member), 1U);
    for (const std::uint32_t other : {0U, 2U, 4U, 6U}) EXPECT_EQ(sets.root(other), other);
  } while (std::next_permutation(joins.begin(), joins.end()));
}

TEST(UnionFind, LeavesASetAsItIsWhenItsMembersAreJoinedAgain) {
  UnionFind sets;
  sets.reset(4);
  sets.join(2, 1);
  sets.join(1, 2);
  sets.join(2, 2);

  EXPECT_EQ(sets.root(2), 1U);
  EXPECT_EQ(sets.root(0), 0U);
}

TEST(UnionFind, AgreesWithSetsThatAreRelabelledAtEachJoin) {
  constexpr std::uint32_t size = 200;
  std::mt19937 random(1);
  for (int round = 0; round < 20; ++round) {
    UnionFind sets;
    sets.reset(size);
    RelabelledSets expected(size);
    for (int i = 0; i < 150; ++i) {
      const auto a = static_cast<std::uint32_t>(random() % size);
      const auto b = static_cast<std::uint32_t>(random() % size);
      sets.join(a, b);
      expected.join(a, b);
      ASSERT_EQ(sets.root(a), expected.root(b));
    }
    for (std::uint32_t m = 0; m < size; ++m) ASSERT_EQ(sets.root(m), expected.root(m)) << m;
  }
}

TEST(UnionFind, GrowsByNumbersThatAreAlone) {
  UnionFind sets;
  sets.reset(0);
  EXPECT_EQ(sets.add(), 0U);
  EXPECT_EQ(sets.add(), 1U);
  sets.join(0, 1);

  EXPECT_EQ(sets.add(), 2U);
  EXPECT_EQ(sets.root(1), 0U);
  EXPECT_EQ(sets.root(2), 2U);
}

TEST(UnionFind, TakesWholeSetsApartAndLeavesTheOthers) {
  UnionFind sets;
  sets.reset(6);
  sets.join(0, 2);
  sets.join(2, 4);
  sets.join(1, 5);

  sets.isolate(std::array{0U, 2U, 4U});

  for (const std::uint32_t member : {0U, 2U, 4U}) EXPECT_EQ(sets.root(member), member);
  EXPECT_EQ(sets.root(5), 1U);
}

TEST(UnionFind, ForgetsEverySetWhenItIsReset) {
  UnionFind sets;
  sets.reset(4);
  sets.join(0, 3);

  sets.reset(4);

  EXPECT_EQ(sets.root(3), 3U);
}

}  // namespace
}  // namespace cleave::segmentation
