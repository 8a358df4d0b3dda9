// SPDX-License-Identifier: BSD-3-Clause
// The npm package of client/javascript: its own tests, and beside our C++ client on one stream.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <map>
#include <sstream>

#include "tests/integration/support/daemons.hpp"
#include "tests/integration/support/small_clouds.hpp"
#include "tests/interop/npm_packages.hpp"

namespace cleave::test {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t javascript_domain = 15;

// The sources are built in a copy of the build folder: npm writes beside its package.json.
class JavaScriptClient : public testing::Test {
 protected:
  void SetUp() override {
    const fs::path source(CLEAVE_SOURCE_DIR);
    fs::create_directories(package_);
    ASSERT_NO_FATAL_FAILURE(install_npm_packages(source / "client" / "javascript", package_));
    for (const char* const name :
         {"client/javascript/tsconfig.json", "client/javascript/README.md",
          "client/javascript/build", "client/javascript/src", "client/javascript/test",
          "client/javascript/examples", "idl", "LICENSE"}) {
      fs::remove_all(copy_ / name);
      fs::copy(source / name, copy_ / name, fs::copy_options::recursive);
    }
  }

  [[nodiscard]] static Process npm(std::vector<std::string> words) {
    words.insert(words.begin(), {"/usr/bin/env", "npm"});
    return Process(words);
  }

  const fs::path copy_ = CLEAVE_JAVASCRIPT_BUILD;
  const fs::path package_ = copy_ / "client" / "javascript";
};

TEST_F(JavaScriptClient, CompilesStrictlyAndPassesItsOwnTests) {
  Process tests = npm({"test", "--prefix", package_.string()});
  EXPECT_EQ(tests.wait(std::chrono::minutes(3)), 0) << tests.output() << tests.log();
}

// Lines "frame N: ..." by N.
std::map<std::uint64_t, std::string> by_frame(const std::string& output) {
  std::map<std::uint64_t, std::string> lines;
  std::istringstream in(output);
  for (std::string line; std::getline(in, line) && !in.eof();) {
    lines[std::stoull(line.substr(std::string("frame ").size()))] = line;
  }
  return lines;
}

TEST_F(JavaScriptClient, PrintsOfEachFrameWhatTheCppExamplePrints) {
  const TemporaryFolder folder;
  const fs::path user = folder.path() / "user";
  fs::create_directories(user);
  Process pack = npm({"pack", package_.string(), "--pack-destination", folder.path().string()});
  ASSERT_EQ(pack.wait(std::chrono::minutes(2)), 0) << pack.log();
  Process install = npm({"install", "--offline", "--no-audit", "--no-fund", "--prefix",
                         user.string(), (folder.path() / "cleave-client-0.1.0.tgz").string()});
  ASSERT_EQ(install.wait(), 0) << install.log();
  fs::copy(package_ / "examples" / "print_segments.mjs", user);

  const fs::path clouds = folder.path() / "clouds";
  fs::create_directories(clouds);
  for (const std::uint32_t width : {72U, 80U, 92U, 100U}) {
    write_pcd(clouds / (std::to_string(width) + ".pcd"), width, 60);
  }
  const Daemons daemons(javascript_domain, false);
  Process cpp = daemons.run("01_print_segments", {});
  Process javascript({"/usr/bin/env", "node", (user / "print_segments.mjs").string()},
                     {{"CLEAVE_DOMAIN", std::to_string(daemons.domain())}});
  Process segmenter = daemons.segmenter();
  Process camera = daemons.grabber("pcd:" + clouds.string(), {"--loop"});
  EXPECT_TRUE(eventually([&] { return by_frame(javascript.output()).size() >= 60; }))
      << javascript.output() << javascript.log() << segmenter.log() << camera.log();
  cpp.signal(SIGTERM);  // what it has printed is in a buffer until it ends
  ASSERT_EQ(cpp.wait(), 0) << cpp.log();

  const auto ours = by_frame(cpp.output());
  const auto theirs = by_frame(javascript.output());
  ASSERT_FALSE(ours.empty());
  ASSERT_FALSE(theirs.empty());
  const std::uint64_t first = std::max(ours.begin()->first, theirs.begin()->first);
  const std::uint64_t last = std::min(ours.rbegin()->first, theirs.rbegin()->first);
  const std::map expected(ours.lower_bound(first), ours.upper_bound(last));
  const std::map found(theirs.lower_bound(first), theirs.upper_bound(last));
  EXPECT_GE(expected.size(), 30U) << cpp.output();
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace cleave::test
