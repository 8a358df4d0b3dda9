// SPDX-License-Identifier: BSD-3-Clause
#include "recording/pcd/encoding/lzf.hpp"

#include <gtest/gtest.h>
#include <liblzf/lzf.h>

#include <random>

namespace cleave::recording {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes random_bytes(std::mt19937& random, std::size_t size, std::size_t kinds) {
  Bytes bytes(size);
  for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random() % kinds);
  return bytes;
}

TEST(Lzf, IsUnpackedByLiblzfToWhatWasPacked) {
  std::mt19937 random(1);
  for (std::size_t i = 0; i < 2000; ++i) {
    Bytes plain = random_bytes(random, 4 + random() % 3000, 1 + random() % 5);
    if (i % 3 == 0) plain.insert(plain.end(), 20000, 7);  // long matches, far matches
    if (i % 3 == 1) plain.insert(plain.end(), plain.begin(), plain.begin() + 4);
    const Bytes block = lzf_compressed(plain);
    if (block.empty()) continue;
    ASSERT_LT(block.size(), plain.size());
    Bytes unpacked(plain.size());
    ASSERT_EQ(lzf_decompress(block.data(), static_cast<unsigned>(block.size()), unpacked.data(),
                             static_cast<unsigned>(unpacked.size())),
              plain.size());
    ASSERT_EQ(unpacked, plain) << i;
  }
}

TEST(Lzf, MakesWhatRepeatsMuchSmaller) {
  EXPECT_LT(lzf_compressed(Bytes(100000, 3)).size(), 1500U);
}

TEST(Lzf, GivesNothingWhereItCannotMakeItSmaller) {
  std::mt19937 random(2);
  EXPECT_TRUE(lzf_compressed(random_bytes(random, 1000, 256)).empty());
  EXPECT_TRUE(lzf_compressed(Bytes{}).empty());
  EXPECT_TRUE(lzf_compressed(Bytes{1, 2}).empty());
}

}  // namespace
}  // namespace cleave::recording
