// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/process/companion.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>
#include <string>

namespace cleave {
namespace {

namespace fs = std::filesystem;

// tests/integration/copied_programs_test.cpp moves programs; this one stays where it was built.
TEST(Companion, IsFoundBesideTheProgramWhateverTheWorkingDirectoryIs) {
  const fs::path program = fs::read_symlink("/proc/self/exe");
  const fs::path before = fs::current_path();
  fs::current_path("/");
  EXPECT_EQ(find_companion(program.filename()), program);
  EXPECT_EQ(companion(program.filename(), "no remedy is needed"), program);
  fs::current_path(before);
}

TEST(Companion, ThatIsMissingIsToldWithThePlacesAndTheRemedy) {
  const fs::path bin = fs::read_symlink("/proc/self/exe").parent_path();
  EXPECT_EQ(find_companion("no-such-file"), std::nullopt);
  try {
    (void)companion("no-such-file", "build it");
    ADD_FAILURE() << "found";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), "there is neither " + (bin / "no-such-file").string() + " nor " +
                                (bin.parent_path() / "lib/cleave/no-such-file").string() +
                                "; build it");
  }
}

}  // namespace
}  // namespace cleave
