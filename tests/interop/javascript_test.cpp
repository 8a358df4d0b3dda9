// SPDX-License-Identifier: BSD-3-Clause
// The client for Node as its users have it: packed, installed from the tarball, and run beside
// ours.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <sstream>

#include "idl/topics.hpp"
#include "libcleave/status.hpp"
#include "tests/integration/support/daemons.hpp"
#include "tests/integration/support/small_clouds.hpp"
#include "tests/interop/npm_packages.hpp"

namespace cleave::test {
namespace {

namespace fs = std::filesystem;

struct Line {
  std::uint64_t frame;
  std::string text;
};

// "frame N: ...". The last line may not be whole yet.
std::vector<Line> lines_of(const std::string& output) {
  std::vector<Line> lines;
  std::istringstream input(output.substr(0, output.rfind('\n') + 1));
  for (std::string text; std::getline(input, text);) {
    lines.push_back({std::stoull(text.substr(text.find(' ') + 1)), text});
  }
  return lines;
}

// Of the frames that both were there for.
std::string common(const std::vector<Line>& lines, const std::vector<Line>& others) {
  std::string text;
  for (const Line& line : lines) {
    if (line.frame < others.front().frame || line.frame > others.back().frame) continue;
    text += line.text + "\n";
  }
  return text;
}

class Javascript : public testing::Test {
 protected:
  // A mirror of what the package is made of, because npm builds where the sources are.
  static void SetUpTestSuite() {
    const fs::path top(CLEAVE_SOURCE_DIR);
    const fs::path sources = top / "client" / "javascript";
    fs::remove_all(mirror() / "idl");
    for (const char* const part : {"build", "examples", "src", "test"}) {
      fs::remove_all(package() / part);
    }
    ASSERT_NO_FATAL_FAILURE(install_npm_packages(sources, package()));
    constexpr auto everything = fs::copy_options::recursive | fs::copy_options::overwrite_existing;
    for (const char* const part : {"build", "examples", "src", "test", "tsconfig.json"}) {
      fs::copy(sources / part, package() / part, everything);
    }
    fs::copy(top / "idl", mirror() / "idl", everything);
    fs::copy(top / "LICENSE", mirror() / "LICENSE", everything);
    fs::copy(sources / "README.md", package() / "README.md", everything);

    fs::remove_all(user());
    fs::create_directories(user());
    npm({"pack", package().string(), "--pack-destination", user().string()});
    for (const auto& entry : fs::directory_iterator(user())) {
      if (entry.path().extension() != ".tgz") continue;
      npm({"install", "--no-audit", "--no-fund", "--prefix", user().string(),
           entry.path().string()});
      break;
    }
  }

  static void npm(const std::vector<std::string>& words) {
    std::vector<std::string> command = {"/usr/bin/env", "npm"};
    command.insert(command.end(), words.begin(), words.end());
    Process process(command);
    ASSERT_EQ(process.wait(std::chrono::minutes(5)), 0) << process.output() << process.log();
  }

  // An example of the package, beside the installed package.
  static Process example(const std::string& name, std::uint32_t domain) {
    const fs::path script = user() / name;
    fs::copy_file(package() / "examples" / name, script, fs::copy_options::overwrite_existing);
    return Process({"/usr/bin/env", "node", script.string()},
                   {{"CLEAVE_DOMAIN", std::to_string(domain)}});
  }

  static fs::path mirror() { return CLEAVE_JAVASCRIPT_MIRROR; }
  static fs::path package() { return mirror() / "client" / "javascript"; }
  static fs::path user() { return mirror() / "user"; }
};

TEST_F(Javascript, PrintsOfEveryFrameWhatTheSameProgramInCppPrints) {
  const TemporaryFolder folder;
  write_pcd(folder.path() / "a.pcd", 80, 60);
  write_pcd(folder.path() / "b.pcd", 100, 60);
  const Daemons daemons(19, false);
  Process segmenter = daemons.segmenter();
  Process camera = daemons.grabber("pcd:" + folder.path().string(), {"--loop"});
  Process ours = daemons.run("01_print_segments", {});
  const Process theirs = example("print_segments.mjs", daemons.domain());

  constexpr std::size_t enough = 60;
  const bool came = eventually([&] { return lines_of(theirs.output()).size() >= enough; });
  ASSERT_TRUE(came) << theirs.output() << theirs.log() << segmenter.log() << camera.log();
  ours.signal(SIGTERM);  // which lets it write what it has buffered
  ASSERT_EQ(ours.wait(), 0) << ours.log();

  const std::vector<Line> cpp = lines_of(ours.output());
  const std::vector<Line> javascript = lines_of(theirs.output());
  ASSERT_FALSE(cpp.empty());
  const std::string printed = common(javascript, cpp);
  EXPECT_GE(std::count(printed.begin(), printed.end(), '\n'), enough / 2);
  EXPECT_EQ(printed, common(cpp, javascript));
}

TEST_F(Javascript, PrintsTheStatusOfBothDaemons) {
  const TemporaryFolder folder;
  write_pcd(folder.path() / "a.pcd", 80, 60);
  const Daemons daemons(19, false);
  const Process segmenter = daemons.segmenter();
  const Process camera = daemons.grabber("pcd:" + folder.path().string(), {"--loop"});
  std::string output;
  const bool both = eventually([&] {
    Process status = example("print_status.mjs", daemons.domain());
    (void)status.wait();
    output = status.output() + status.log();
    return output.find("segmenter/camera: STATE_RUNNING") != std::string::npos &&
           output.find("grabber/camera: STATE_RUNNING") != std::string::npos;
  });
  EXPECT_TRUE(both) << output << segmenter.log() << camera.log();
}

TEST_F(Javascript, NamesANodeOfAnotherContractAndRefusesIt) {
  StreamOptions options;
  options.domain = 19;
  options.shared_memory = false;
  Stream stream(options);
  StatusPublisher publisher(stream);
  NodeReport report = first_report(stream, segmenter_node("camera"), "camera");
  report.contract = "cleave_v0";
  publisher.publish(report);
  Process lists = example("print_segments.mjs", options.domain);
  Process status = example("print_status.mjs", options.domain);
  for (Process* const process : {&lists, &status}) {
    EXPECT_EQ(process->wait(), 1) << process->output();
    EXPECT_NE(
        process->log().find("ContractError: segmenter/camera speaks the contract 'cleave_v0', "
                            "this package cleave_v1"),
        std::string::npos)
        << process->log();
  }
}

TEST_F(Javascript, PassesItsOwnTests) {
  npm({"test", "--prefix", package().string()});
}

}  // namespace
}  // namespace cleave::test
