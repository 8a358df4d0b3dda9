// SPDX-License-Identifier: BSD-3-Clause
// The pages of client/examples in languages that reach the stream through the C interface, built
// and run by the very commands that each says on top, beside the same page in C.
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "tests/integration/support/daemons.hpp"
#include "tests/integration/support/roudi_fixture.hpp"

namespace cleave::test {
namespace {

namespace fs = std::filesystem;

struct Language {
  const char* name;
  const char* page;                // in client/examples
  std::vector<const char*> files;  // what Debian's packages bring; without one it is skipped
};

void PrintTo(const Language& language, std::ostream* output) {
  *output << language.name;
}

struct Commands {
  std::string install;
  std::vector<std::string> build;
  std::string run;
};

// The indented lines of the page's first comment. They are written for build/release, and run with
// the build folder of this test.
Commands commands_of(const fs::path& page) {
  static const std::regex command(R"(^(?://!?|--)(?:\t|    +)(\S.*)$)");
  static const std::regex build_folder(R"((\$PWD/)?build/release)");
  const std::string folder = fs::path(program("")).parent_path().parent_path().string();
  std::vector<std::string> lines;
  std::ifstream input(page);
  std::smatch match;
  for (std::string line; std::getline(input, line);) {
    if (std::regex_match(line, match, command)) {
      lines.push_back(std::regex_replace(match[1].str(), build_folder, folder));
    }
  }
  if (lines.size() < 2) throw std::runtime_error(page.string() + " says no commands on top");
  return {lines.front(), {lines.begin() + 1, lines.end() - 1}, lines.back()};
}

// Frame by frame what was printed of it: "frame N: ...".
std::map<std::uint64_t, std::string> by_frame(const std::string& text) {
  static const std::regex pattern("^frame ([0-9]+): .*");
  std::map<std::uint64_t, std::string> lines;
  std::istringstream input(text);
  std::smatch match;
  for (std::string line; std::getline(input, line);) {
    if (std::regex_match(line, match, pattern)) lines[std::stoull(match[1].str())] += line + "\n";
  }
  return lines;
}

void expect_same(const std::string& text, const std::string& other, std::size_t at_least) {
  const auto lines = by_frame(text);
  const auto others = by_frame(other);
  std::size_t common = 0;
  for (const auto& [frame, line] : lines) {
    const auto found = others.find(frame);
    if (found == others.end()) continue;
    EXPECT_EQ(line, found->second);
    ++common;
  }
  EXPECT_GE(common, at_least) << text << other;
}

class Page : public testing::TestWithParam<Language> {
 protected:
  static constexpr std::uint32_t domain = 49;

  void SetUp() override {
    commands_ = commands_of(fs::path(CLEAVE_SOURCE_DIR) / "client/examples" / GetParam().page);
    for (const char* const file : GetParam().files) {
      if (!fs::exists(file)) GTEST_SKIP() << "no " << file << " here: " << commands_.install;
    }
    for (const std::string& command : commands_.build) {
      Process build = shell(command);
      ASSERT_EQ(build.wait(std::chrono::minutes(5)), 0) << command << "\n" << build.log();
    }
  }

  // With the library of this build, or of another folder.
  [[nodiscard]] Process run(const std::string& words, const fs::path& libraries = {}) const {
    static const std::regex arguments(R"(\[SENSOR \[FRAMES\]\])");
    static const std::regex library_path("LD_LIBRARY_PATH=[^ ]+");
    std::string command = std::regex_replace(commands_.run, arguments, words);
    if (!libraries.empty()) {
      command = std::regex_replace(command, library_path, "LD_LIBRARY_PATH=" + libraries.string());
    }
    return shell("exec env " + command);
  }

 private:
  // At the top of the checkout, with Debian's compilers rather than others that this machine has.
  static Process shell(const std::string& command) {
    return Process({"/usr/bin/env", "bash", "-c", "cd '" CLEAVE_SOURCE_DIR "' && " + command},
                   {{"CLEAVE_DOMAIN", std::to_string(domain)}, {"PATH", "/usr/bin:/bin"}});
  }

  Commands commands_;
};

TEST_P(Page, PrintsWhatTheOneInCPrintsInPlaceAndSaysWhenNobodyIsThere) {
  const RouDi roudi;
  const Daemons daemons(domain, true);
  Process in_c = daemons.run("c_largest_object", {"camera", "10"});
  Process page = run("camera 30");
  for (Process* const reader : {&in_c, &page}) {
    ASSERT_TRUE(reader->logs("nobody publishes the sensor's clouds")) << reader->log();
  }
  Process segmenter = daemons.segmenter();
  ASSERT_TRUE(segmenter.logs("segmenting sensor 'camera'")) << segmenter.log();
  Process first = daemons.grabber("synthetic:simple", {"--fps", "10", "--frames", "20"});
  EXPECT_EQ(in_c.wait(), 0) << in_c.log() << segmenter.log() << first.log();
  EXPECT_EQ(first.wait(), 0) << first.log();
  const auto says_that_it_is_gone = [&] {
    const std::string log = page.log();
    return log.rfind("nobody publishes") > log.rfind("frame ");
  };
  ASSERT_TRUE(eventually(says_that_it_is_gone)) << page.log();
  expect_same(page.output(), in_c.output(), 5);
  expect_same(page.log(), in_c.log(), 5);

  const Process second = daemons.grabber("synthetic:simple");
  EXPECT_EQ(page.wait(), 0) << page.log() << segmenter.log() << second.log();
  EXPECT_EQ(page.log().find("(copied)"), std::string::npos) << page.log();
}

TEST_P(Page, RefusesInTheLibrarysWordsANameThatNoSensorCanHave) {
  Process page = run("a-b");
  EXPECT_EQ(page.wait(), 1) << page.output();
  const std::string words = "\na sensor's name is of 1 to 63 letters, digits or '_', not 'a-b'\n";
  EXPECT_NE(("\n" + page.log()).find(words), std::string::npos) << page.log();
}

// Linked ones ask the loader for a version, and the others the library.
TEST_P(Page, RefusesALibraryOfAnotherVersionByItsName) {
  static const std::regex words(
      R"(libcleave-c(\.so\.1: cannot open| has ABI version 999, .* 1\n))");
  const TemporaryFolder other;
  fs::create_symlink(CLEAVE_OTHER_VERSION, other.path() / "libcleave-c.so");
  Process page = run("camera", other.path());
  EXPECT_NE(page.wait(), 0) << page.output();
  EXPECT_TRUE(std::regex_search(page.log(), words)) << page.log();
}

INSTANTIATE_TEST_SUITE_P(
    InAnotherLanguage, Page,
    testing::Values(
        Language{"Rust", "rust/largest_object.rs", {"/usr/bin/rustc"}},
        Language{"Go", "go/largest_object.go", {"/usr/bin/go"}},
        Language{"Java", "java/LargestObject.java", {"/usr/bin/javac", "/usr/share/java/jna.jar"}},
        Language{"CSharp", "csharp/LargestObject.cs", {"/usr/bin/mcs", "/usr/bin/mono"}},
        Language{"Lua", "lua/largest_object.lua", {"/usr/bin/luajit"}}),
    [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace cleave::test
