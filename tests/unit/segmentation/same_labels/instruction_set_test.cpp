// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <memory>
#include <string>

namespace {

std::string output_of(const char* program) {
  const auto close = [](std::FILE* pipe) { pclose(pipe); };
  const std::unique_ptr<std::FILE, decltype(close)> pipe(popen(program, "r"), close);
  std::string text;
  std::array<char, 256> buffer{};
  while (pipe && std::fgets(buffer.data(), buffer.size(), pipe.get()) != nullptr) {
    text += buffer.data();
  }
  return text;
}

TEST(Labels, AreTheSameOnEveryInstructionSet) {
  const std::string widest = output_of(CLEAVE_LABEL_HASH);

  constexpr std::size_t line = 17;  // a hash of 64 bits
  EXPECT_GE(widest.size(), 8 * line);
  EXPECT_EQ(widest.size() % line, 0U) << widest;
  EXPECT_EQ(output_of(CLEAVE_LABEL_HASH_BASELINE), widest);
  EXPECT_EQ(output_of(CLEAVE_LABEL_HASH_UNOPTIMISED), widest);
}

}  // namespace
