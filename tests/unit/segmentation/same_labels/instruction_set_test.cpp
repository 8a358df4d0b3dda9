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

  EXPECT_EQ(widest.size(), 8 * 17U) << "eight hashes";
  EXPECT_EQ(output_of(CLEAVE_LABEL_HASH_BASELINE), widest);
  EXPECT_EQ(output_of(CLEAVE_LABEL_HASH_UNOPTIMISED), widest);
}

}  // namespace
