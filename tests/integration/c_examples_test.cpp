// SPDX-License-Identifier: BSD-3-Clause
// The examples in C against the running daemon, over shared memory.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/integration/support/daemons.hpp"
#include "tests/integration/support/roudi_fixture.hpp"

namespace cleave::test {
namespace {

std::set<std::string> lines_of(const std::string& text) {
  std::set<std::string> lines;
  std::istringstream input(text);
  for (std::string line; std::getline(input, line);) lines.insert(line);
  return lines;
}

std::size_t count_of(const std::string& word, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    ++count;
  }
  return count;
}

TEST(ExamplesInC, PrintWhatThoseInCppPrintAndReadCloudsInPlace) {
  const RouDi roudi;
  const Daemons daemons(47, true);
  Process segmenter = daemons.segmenter({});
  ASSERT_TRUE(segmenter.logs("segmenting sensor 'camera'")) << segmenter.log();
  Process in_cpp = daemons.run("01_print_segments", {"camera"});
  Process in_c = daemons.run("c_largest_object", {"camera", "20"});
  Process grabber = daemons.grabber("synthetic:simple", {});

  EXPECT_EQ(in_c.wait(), 0) << in_c.log() << segmenter.log() << grabber.log();
  in_cpp.signal(SIGTERM);
  EXPECT_EQ(in_cpp.wait(), 0) << in_cpp.log();
  const std::set<std::string> cpp_lines = lines_of(in_cpp.output());
  const std::set<std::string> c_lines = lines_of(in_c.output());
  EXPECT_EQ(c_lines.size(), 20U) << in_c.output();
  EXPECT_TRUE(std::ranges::includes(cpp_lines, c_lines)) << in_cpp.output() << in_c.output();
  EXPECT_EQ(count_of("(zero copy)", in_c.log()), 20U) << in_c.log();
}

TEST(ExamplesInC, PublishACameraThatTheDaemonSegments) {
  const RouDi roudi;
  const Daemons daemons(48, true);
  Process segmenter = daemons.segmenter({});
  ASSERT_TRUE(segmenter.logs("segmenting sensor 'camera'")) << segmenter.log();
  Process reader = daemons.run("cleave", {"echo", "--sensor", "camera", "--json", "--frames", "3"});
  Process camera = daemons.run("c_own_camera", {"90"});
  EXPECT_EQ(reader.wait(), 0) << reader.log() << camera.log() << segmenter.log();
  EXPECT_NE(reader.output().find("segmented"), std::string::npos) << reader.output();
  EXPECT_EQ(camera.wait(), 0) << camera.log();
  EXPECT_EQ(camera.log().find("dropped"), std::string::npos) << camera.log();
}

}  // namespace
}  // namespace cleave::test
