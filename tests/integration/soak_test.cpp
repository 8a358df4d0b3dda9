// SPDX-License-Identifier: BSD-3-Clause
// A short version of benchmark_soak, which runs 10,000 frames.
#include "tests/integration/support/soak.hpp"

#include <gtest/gtest.h>

#include "tests/integration/support/roudi_fixture.hpp"

namespace cleave::test {
namespace {

TEST(Soak, MemoryStaysFlatAndLabelsStayTheSameAfter500Of1500Frames) {
  const RouDi roudi;
  const SoakResult result = soak(1500, 22, [](std::size_t) {});
  EXPECT_EQ(result.frames, 1500U);
  EXPECT_EQ(result.scenes, 8U);
  EXPECT_EQ(result.differing, 0U);
  for (const SoakResult::Memory& memory : result.memory) {
    EXPECT_GT(memory.samples, 0U) << memory.process;
    EXPECT_LE(memory.spread_kb(), 2048U) << memory.process;
  }
}

}  // namespace
}  // namespace cleave::test
