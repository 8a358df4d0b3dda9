// SPDX-License-Identifier: BSD-3-Clause
// The client for Node as its users have it, beside ours: segment lists and statuses.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>

#include "idl/topics.hpp"
#include "libcleave/status.hpp"
#include "tests/integration/support/daemons.hpp"
#include "tests/integration/support/small_clouds.hpp"
#include "tests/interop/javascript_package.hpp"

namespace cleave::test {
namespace {

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
