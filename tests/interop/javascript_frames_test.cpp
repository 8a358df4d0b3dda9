// SPDX-License-Identifier: BSD-3-Clause
// The client for Node on the camera's machine: clouds and label maps through koffi and libcleave-c.
#include <gtest/gtest.h>

#include <map>

#include "tests/integration/support/daemons.hpp"
#include "tests/integration/support/roudi_fixture.hpp"
#include "tests/interop/javascript_package.hpp"

namespace cleave::test {
namespace {

TEST_F(Javascript, SaysWhatCloudsNeedAndRefusesALibraryOfAnotherVersion) {
  remove_koffi();
  Process without = example("print_frames.mjs", 19);
  EXPECT_EQ(without.wait(), 1) << without.output();
  EXPECT_NE(without.log().find("`npm install koffi`"), std::string::npos) << without.log();
  install_koffi();
  Process other = example("print_frames.mjs", 19, CLEAVE_OTHER_VERSION);
  EXPECT_EQ(other.wait(), 1) << other.output();
  EXPECT_NE(other.log().find("has the C interface's version 999, and this package is made for "
                             "version 1"),
            std::string::npos)
      << other.log();
}

TEST_F(Javascript, ReadsCloudsInPlaceAsTheSameProgramInC) {
  install_koffi();
  const RouDi roudi;
  const Daemons daemons(19, true);
  Process segmenter = daemons.segmenter();
  ASSERT_TRUE(segmenter.logs("segmenting sensor 'camera'")) << segmenter.log();
  const Process in_c = daemons.run("c_largest_object", {});
  const Process theirs = example("print_frames.mjs", daemons.domain());
  const Process camera = daemons.grabber("synthetic:simple");

  constexpr std::size_t enough = 20;
  const bool came = eventually([&] { return lines_of(theirs.log()).size() >= enough; });
  ASSERT_TRUE(came) << theirs.log() << segmenter.log() << camera.log();
  const std::vector<Line> javascript = lines_of(theirs.log());
  const auto reached = [&] {
    const std::vector<Line> printed = lines_of(in_c.log());
    return !printed.empty() && printed.back().frame >= javascript.back().frame;
  };
  ASSERT_TRUE(eventually(reached)) << in_c.log();
  std::map<std::uint64_t, std::string> c;
  for (const Line& line : lines_of(in_c.log())) c[line.frame] = line.text;
  std::size_t both = 0;
  for (const Line& line : javascript) {
    if (!c.contains(line.frame)) continue;
    EXPECT_EQ(line.text, c.at(line.frame));
    EXPECT_NE(line.text.find("(zero copy)"), std::string::npos) << line.text;
    ++both;
  }
  EXPECT_GE(both, enough / 2) << theirs.log() << in_c.log();
}

TEST_F(Javascript, HandsOutFramesThatAreWholeAndTakesThemBack) {
  const RouDi roudi;
  const Daemons daemons(19, true);
  const Process segmenter = daemons.segmenter();
  const Process camera = daemons.grabber("synthetic:simple");
  const std::filesystem::path script = package() / "test" / "frames_of_a_camera.mjs";
  Process frames = node({"--expose-gc", script.string()}, daemons.domain());
  EXPECT_EQ(frames.wait(std::chrono::minutes(3)), 0)
      << frames.output() << frames.log() << segmenter.log() << camera.log();
}

}  // namespace
}  // namespace cleave::test
