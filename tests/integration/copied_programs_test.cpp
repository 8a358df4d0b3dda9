// SPDX-License-Identifier: BSD-3-Clause
// The programs in other places than where they were built: what comes with them is found all the
// same, and whoever lacks it is told where it was looked for.
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <initializer_list>

#include "tests/integration/support/daemons.hpp"
#include "tests/integration/support/process.hpp"
#include "tests/integration/support/small_clouds.hpp"

namespace cleave::test {
namespace {

namespace fs = std::filesystem;

constexpr char driver[] = "openni2/OpenNI2/Drivers/libCleaveSynthetic.so.0";

class CopiedPrograms : public testing::Test {
 protected:
  void copy(std::initializer_list<const char*> names, const fs::path& folder) const {
    fs::create_directories(prefix() / folder);
    for (const char* const name : names) {
      fs::copy(program(name), prefix() / folder / name,
               fs::copy_options::recursive | fs::copy_options::copy_symlinks);
    }
  }
  [[nodiscard]] fs::path prefix() const { return folder_.path() / "prefix"; }
  [[nodiscard]] Process run(const std::string& name, std::vector<std::string> words) const {
    words.insert(words.begin(), (prefix() / "bin" / name).string());
    return Process(words, {{"CLEAVE_DOMAIN", "33"}});
  }
  [[nodiscard]] Process grab_synthetic() const {
    return run("cleave-grabber",
               {"--config", std::string(CLEAVE_SOURCE_DIR) + "/config/grabber.yaml",
                "--no-shared-memory", "--source", "synthetic:simple?frames=1&fps=10"});
  }
  // Both places are named, and what to do.
  void expect_missing(Process& process, const std::string& file, const std::string& remedy) const {
    EXPECT_EQ(process.wait(), 1);
    for (const fs::path& place : {prefix() / "bin", prefix() / "lib" / "cleave"}) {
      EXPECT_NE(process.log().find((place / file).string()), std::string::npos) << process.log();
    }
    EXPECT_NE(process.log().find(remedy), std::string::npos) << process.log();
  }

  // A command of the workbench's, PCL's methods, and the synthetic camera.
  void expect_all_found() const {
    const fs::path cloud = folder_.path() / "cloud.pcd";
    write_pcd(cloud, 80, 60);
    Process bench =
        run("cleave", {"bench", cloud.string(), "--repeat", "1", "--against", "pcl", "--json"});
    EXPECT_EQ(bench.wait(), 0) << bench.log();
    Process grabber = grab_synthetic();
    EXPECT_TRUE(grabber.logs("opened Cleave Synthetic camera")) << grabber.log();
    grabber.signal(SIGTERM);
    EXPECT_EQ(grabber.wait(), 0) << grabber.log();
  }

  TemporaryFolder folder_;
};

TEST_F(CopiedPrograms, FindWhatIsCopiedBesideThem) {
  copy({"cleave", "cleave-grabber", "cleave-workbench", "libcleave_peers.so", "openni2"}, "bin");
  expect_all_found();
}

TEST_F(CopiedPrograms, FindWhatIsInLibCleaveAsAnInstallationHasIt) {
  copy({"cleave", "cleave-grabber", "cleave-workbench"}, "bin");
  copy({"libcleave_peers.so", "openni2"}, fs::path("lib") / "cleave");
  expect_all_found();
}

TEST_F(CopiedPrograms, HandOverEveryWordAsItIs) {
  copy({"cleave", "cleave-workbench"}, "bin");
  const fs::path in = folder_.path() / "cloud.pcd";
  const fs::path out = folder_.path() / "labelled.pcd";
  write_pcd(in, 80, 60);
  Process segment = run("cleave", {"segment", "--json", "--", in.string(), out.string()});
  EXPECT_EQ(segment.wait(), 0) << segment.log();
  EXPECT_TRUE(fs::exists(out));
}

TEST_F(CopiedPrograms, SayWhereTheyLookedForAProgramThatIsNotThere) {
  copy({"cleave"}, "bin");
  Process segment = run("cleave", {"segment", "--help"});
  expect_missing(segment, "cleave-workbench", "install the package cleave-workbench");
}

TEST_F(CopiedPrograms, SayWhereTheyLookedForTheirConfiguration) {
  if (fs::exists("/etc/cleave")) GTEST_SKIP() << "Cleave is installed on this machine";
  copy({"cleave-grabber", "cleave-segmenter"}, "bin");
  for (const std::string name : {"grabber", "segmenter"}) {
    Process daemon = run("cleave-" + name, {});
    EXPECT_EQ(daemon.wait(), 2);
    for (const fs::path& place : {prefix() / "etc" / "cleave", fs::path("/etc/cleave")}) {
      EXPECT_NE(daemon.log().find((place / (name + ".yaml")).string()), std::string::npos)
          << daemon.log();
    }
    EXPECT_NE(daemon.log().find("--config"), std::string::npos) << daemon.log();
  }
}

TEST_F(CopiedPrograms, SayWhereTheyLookedForTheRenderer) {
  copy({"cleave-workbench"}, "bin");
  Process study = run("cleave-workbench", {"study", "cannot-link-threshold", "--output",
                                           (folder_.path() / "study").string()});
  expect_missing(study, "cleave-render", "name a folder of labelled scenes");
}

TEST_F(CopiedPrograms, SayWhereTheyLookedForAPlugIn) {
  copy({"cleave-workbench"}, "bin");
  const fs::path cloud = folder_.path() / "cloud.pcd";
  write_pcd(cloud, 80, 60);
  Process bench = run("cleave-workbench", {"bench", cloud.string(), "--against", "pcl"});
  expect_missing(bench, "libcleave_peers.so", "cleave_peers_module");
}

TEST_F(CopiedPrograms, SayWhereTheyLookedForTheSyntheticCamera) {
  copy({"cleave-grabber"}, "bin");
  Process grabber = grab_synthetic();
  expect_missing(grabber, driver, "cleave_synthetic_driver");
}

}  // namespace
}  // namespace cleave::test
