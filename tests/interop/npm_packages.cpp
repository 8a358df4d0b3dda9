// SPDX-License-Identifier: BSD-3-Clause
#include "tests/interop/npm_packages.hpp"

#include <gtest/gtest.h>

#include "tests/integration/support/process.hpp"
#include "tests/unit/recording/recording_files.hpp"

namespace cleave::test {

namespace fs = std::filesystem;

void install_npm_packages(const fs::path& source, const fs::path& folder) {
  const fs::path lock = folder / "package-lock.json";
  if (fs::exists(folder / "node_modules" / ".package-lock.json") &&
      recording::read_all(lock) == recording::read_all(source / "package-lock.json")) {
    return;
  }
  fs::create_directories(folder);
  for (const char* const name : {"package.json", "package-lock.json"}) {
    fs::copy_file(source / name, folder / name, fs::copy_options::overwrite_existing);
  }
  Process npm(
      {"/usr/bin/env", "npm", "ci", "--no-audit", "--no-fund", "--prefix", folder.string()});
  ASSERT_EQ(npm.wait(std::chrono::minutes(3)), 0)
      << "npm cannot install what " << source
      << " names (is its registry reachable?): " << npm.log();
}

}  // namespace cleave::test
