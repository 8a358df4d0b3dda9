// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/studies/program.hpp"

#include <gtest/gtest.h>

namespace cleave::workbench {
namespace {

TEST(RunProgram, TellsHowAProgramEnded) {
  EXPECT_EQ(run_program({"true"}), ProgramEnd::done);
  EXPECT_EQ(run_program({"false"}), ProgramEnd::failed);
  EXPECT_EQ(run_program({"sh", "-c", "kill -9 $$"}), ProgramEnd::failed);
  EXPECT_EQ(run_program({"no-such-program-anywhere"}), ProgramEnd::not_found);
}

TEST(RunProgram, PassesWordsOnAsTheyAre) {
  EXPECT_EQ(run_program({"test", "two words; $HOME", "=", "two words; $HOME"}), ProgramEnd::done);
}

}  // namespace
}  // namespace cleave::workbench
