// SPDX-License-Identifier: BSD-3-Clause
// Golden files, damaged a thousand times each by a seed: for whoever reads CDR.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "tests/unit/golden/golden_files.hpp"

namespace cleave::test {

inline constexpr int mutations = 1000;
// How far into a file damage reaches.
inline constexpr std::size_t whole_file = SIZE_MAX;
inline constexpr std::size_t bulk_header = 400;  // behind it are numbers alone

// Flips bits, or puts a number where a length may be, among the first `reach` bytes; and cuts off.
class Damage {
 public:
  explicit Damage(std::size_t reach) : reach_(reach) {}

  // The part of `bytes` that is left.
  std::span<const std::byte> apply(std::vector<std::byte>& bytes) {
    const std::size_t reach = std::min(reach_, bytes.size());
    // Of megabytes of numbers few are looked at whole, for the sake of time.
    const bool bulk = reach < bytes.size();
    switch (below(3)) {
      case 0:
        break;
      case 1:
        for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
          bytes[below(reach)] ^= static_cast<std::byte>(1U << below(8));
        }
        if (bulk && below(50) != 0) break;
        return bytes;
      default: {
        const std::array<std::uint32_t, 7> lies = {
            0, 1, 17, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF, static_cast<std::uint32_t>(bytes.size())};
        const std::uint32_t lie = lies.at(below(lies.size()));
        std::memcpy(&bytes[4 * below(reach / 4)], &lie, sizeof lie);
        if (bulk && below(50) != 0) break;
        return bytes;
      }
    }
    const bool at_the_end = below(bulk ? 50 : 2) == 0;
    return std::span(bytes).first(at_the_end ? bytes.size() - 1 - below(9) : below(reach));
  }

 private:
  std::size_t below(std::size_t limit) { return static_cast<std::size_t>(random_() % limit); }
  std::mt19937 random_{11};
  std::size_t reach_;
};

// How many of all mutations `read` takes; it returns false for what it refuses.
template <class Read>
void damage(const std::string& type, std::size_t reach, const Read& read) {
  for (const GoldenSample& golden : golden_samples(type)) {
    for (const std::vector<std::byte>& whole : {golden.little_endian, golden.big_endian}) {
      Damage damage(reach);
      std::vector<std::byte> bytes = whole;
      int taken = 0;
      for (int i = 0; i < mutations; ++i) {
        if (read(damage.apply(bytes))) ++taken;
        std::copy_n(whole.begin(), std::min(reach, whole.size()), bytes.begin());
      }
      EXPECT_GT(taken, 0) << golden.name;
      EXPECT_LT(taken, mutations) << golden.name;
    }
  }
}

}  // namespace cleave::test
