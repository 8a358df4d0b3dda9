// SPDX-License-Identifier: BSD-3-Clause
// An installation that was moved after `cmake --install`: its programs find what is theirs, and
// clients outside the checkout are built against it, by find_package and by pkg-config.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/integration/support/process.hpp"
#include "tests/integration/support/roudi_fixture.hpp"

namespace cleave::test {
namespace {

namespace fs = std::filesystem;

class Installed : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    const fs::path build = fs::path(program("cleave")).parent_path().parent_path();
    Process install({"/usr/bin/env", "cmake", "--install", build.string(), "--prefix",
                     chosen_prefix().string()});
    ASSERT_EQ(install.wait(), 0) << install.log();
    fs::rename(chosen_prefix(), prefix());
  }
  static void TearDownTestSuite() { delete folder_; }

  static fs::path chosen_prefix() { return folder_->path() / "chosen"; }
  static fs::path prefix() { return folder_->path() / "moved"; }
  static fs::path work() { return folder_->path() / "work"; }

  static Process run(const std::string& name, const std::vector<std::string>& words) {
    std::vector<std::string> command = {(prefix() / "bin" / name).string()};
    command.insert(command.end(), words.begin(), words.end());
    return Process(command, {{"CLEAVE_DOMAIN", "61"}});
  }
  // A line of shell that must succeed, in a folder outside the checkout.
  static void shell(const std::string& line) {
    fs::create_directories(work());
    Process process({"/bin/sh", "-ec", "cd " + work().string() + "; " + line},
                    {{"PKG_CONFIG_PATH", (prefix() / "share" / "pkgconfig").string()},
                     {"LD_LIBRARY_PATH", (prefix() / "lib").string()},
                     {"PYTHONPATH", (prefix() / "lib/python3/dist-packages").string()}});
    ASSERT_EQ(process.wait(std::chrono::minutes(5)), 0) << line << '\n'
                                                        << process.output() << process.log();
  }
  static void write(const std::string& name, const std::string& text) {
    fs::create_directories((work() / name).parent_path());
    std::ofstream(work() / name) << text;
  }
  static std::string example(const std::string& path) {
    return std::string(CLEAVE_SOURCE_DIR) + "/client/examples/" + path;
  }

  // The planner of client/examples with the installation's daemons, which name no configuration.
  static void expect_zero_copy(const fs::path& planner) {
    const RouDi roudi(prefix() / "etc/cleave/roudi.toml");
    Process segmenter = run("cleave-segmenter", {});
    ASSERT_TRUE(segmenter.logs("segmenting sensor 'camera'")) << segmenter.log();
    Process plans({planner.string(), "camera", "20"}, {{"CLEAVE_DOMAIN", "61"}});
    Process grabber = run("cleave-grabber", {"--source", "synthetic:simple"});
    EXPECT_EQ(plans.wait(), 0) << plans.log() << segmenter.log() << grabber.log();
    const std::string output = plans.output();
    EXPECT_EQ(std::ranges::count(output, '\n'), 20) << output;
    EXPECT_NE(output.find("(zero copy)"), std::string::npos) << output;
    EXPECT_EQ(output.find("(copied)"), std::string::npos) << output;
  }

  inline static TemporaryFolder* folder_ = nullptr;
};

TEST_F(Installed, RunsAPlannerThatIsBuiltWithFindPackage) {
  shell("cp -r " + example("planner") +
        " .; cmake -S planner -B planner/build -DCMAKE_PREFIX_PATH=" + prefix().string() +
        "; cmake --build planner/build");
  expect_zero_copy(work() / "planner/build/planner");
}

TEST_F(Installed, RunsAPlannerThatIsBuiltWithPkgConfig) {
  shell("c++ -std=c++20 -Wall -Wextra -Werror -o by-pkg-config " + example("planner/planner.cpp") +
        " $(pkg-config --cflags --libs cleave)");
  expect_zero_copy(work() / "by-pkg-config");
}

TEST_F(Installed, BuildsTheSegmentationAloneAndTheStreamInC) {
  write("alone/segments.cpp",
        "#include \"segmentation/segmenter.hpp\"\n"
        "int main() { cleave::segmentation::Segmenter segmenter{{}}; }\n");
  write("alone/version.c",
        "#include <cleave.h>\n#include <stdio.h>\n"
        "int main(void) { return puts(cleave_version()) < 0; }\n");
  write("alone/CMakeLists.txt",
        "cmake_minimum_required(VERSION 3.25)\nproject(alone)\n"
        "find_package(cleave 0.1 REQUIRED COMPONENTS segmentation c)\n"
        "add_executable(segments segments.cpp)\n"
        "target_link_libraries(segments cleave::segmentation)\n"
        "add_executable(version version.c)\ntarget_link_libraries(version cleave::c)\n");
  shell("cmake -S alone -B alone/build -DCMAKE_PREFIX_PATH=" + prefix().string() +
        "; cmake --build alone/build; alone/build/segments; alone/build/version");
  shell(
      "c++ -std=c++20 -o segments alone/segments.cpp $(pkg-config --cflags --libs "
      "cleave-segmentation); ./segments");
  shell("cc -o version alone/version.c $(pkg-config --cflags --libs cleave-c); ./version");
}

TEST_F(Installed, BringsAPackageThatPythonLoads) {
  shell(
      "env -u CLEAVE_LIBRARY -u LD_LIBRARY_PATH /usr/bin/python3 -B -c 'import cleave; "
      "print(cleave.__version__)'");
}

TEST_F(Installed, HasUnitsThatNameTheProgramsAndFilesOfThePrefix) {
  std::size_t named = 0;
  for (const char* const unit : {"cleave-roudi", "cleave-segmenter", "cleave-grabber"}) {
    std::ifstream file(prefix() / "lib/systemd/system" / (std::string(unit) + ".service"));
    ASSERT_TRUE(file) << unit;
    for (std::string word; file >> word;) {
      EXPECT_EQ(word.find('@'), std::string::npos) << word;
      const std::size_t at = word.find(chosen_prefix().string());
      if (at == std::string::npos) continue;
      ++named;
      const std::string inside = word.substr(at + chosen_prefix().string().size());
      EXPECT_TRUE(fs::exists(prefix().string() + inside)) << unit << ": " << word;
    }
  }
  EXPECT_EQ(named, 5U);  // a program and a file of each daemon, and RouDi's pools
}

TEST_F(Installed, HasAPageAndCompletionOfEveryProgram) {
  for (const fs::directory_entry& entry : fs::directory_iterator(prefix() / "bin")) {
    const std::string name = entry.path().filename();
    EXPECT_TRUE(fs::exists(prefix() / "share/man/man1" / (name + ".1"))) << name;
    EXPECT_TRUE(fs::exists(prefix() / "share/bash-completion/completions" / name)) << name;
  }
  // What bash would offer for `cleave record --d`, a command's own option.
  shell("bash -ec '. " + (prefix() / "share/bash-completion/completions/cleave").string() +
        "; COMP_WORDS=(cleave record --d) COMP_CWORD=2; _cleave; "
        "[ \"${COMPREPLY[*]}\" = \"--domain --duration\" ]'");
}

}  // namespace
}  // namespace cleave::test
