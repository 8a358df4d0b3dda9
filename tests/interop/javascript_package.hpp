// SPDX-License-Identifier: BSD-3-Clause
// The client for Node as its users have it: packed, installed from the tarball, and run.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/integration/support/process.hpp"

namespace cleave::test {

struct Line {
  std::uint64_t frame;
  std::string text;
};

// Those of "frame N: ...". The last line may not be whole yet.
std::vector<Line> lines_of(const std::string& output);

// Of the frames that both were there for.
std::string common(const std::vector<Line>& lines, const std::vector<Line>& others);

class Javascript : public testing::Test {
 protected:
  static void SetUpTestSuite();

  static void npm(const std::vector<std::string>& words);
  static Process node(const std::vector<std::string>& words, std::uint32_t domain,
                      const std::string& library = CLEAVE_C_LIBRARY);
  // An example of the package, beside the installed package.
  static Process example(const std::string& name, std::uint32_t domain,
                         const std::string& library = CLEAVE_C_LIBRARY);
  // The one that the package's own tests have, as npm links a package that is a folder.
  static void install_koffi();
  static void remove_koffi();
  // Where the package is built.
  static std::filesystem::path package();
};

}  // namespace cleave::test
