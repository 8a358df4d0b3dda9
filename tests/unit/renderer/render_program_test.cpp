// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <pcl/PCLPointCloud2.h>
#include <pcl/io/pcd_io.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "sensor/renderer/scene/scene_loop.hpp"

namespace cleave::render {
namespace {

class RenderProgram : public testing::Test {
 protected:
  RenderProgram() { std::filesystem::create_directory(folder_); }
  ~RenderProgram() override { std::filesystem::remove_all(folder_); }

  // The exit code.
  [[nodiscard]] int run(const std::string& arguments) const {
    const std::string command = CLEAVE_RENDER " " + arguments + " 2>" + (folder_ / "log").string();
    return WEXITSTATUS(std::system(command.c_str()));
  }
  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_ / name).string();
  }
  [[nodiscard]] std::string content(const std::string& name) const {
    std::ifstream file(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("cleave_render_" + std::to_string(::getpid()));
};

TEST_F(RenderProgram, WritesTheFirstFrameOfTheSourceWithItsTruth) {
  ASSERT_EQ(run("'synthetic:simple?seed=3' " + path("out")), 0) << content("log");

  pcl::PCLPointCloud2 cloud;
  ASSERT_EQ(pcl::PCDReader().read(path("out/simple3.pcd"), cloud), 0);
  const LabelledDepth image = SceneLoop(parse_scene("simple?seed=3")).frame(0);
  const std::vector<float> xyz = to_points(image, Intrinsics{});
  ASSERT_EQ(cloud.width, 640U);
  ASSERT_EQ(cloud.height, 480U);
  ASSERT_EQ(cloud.point_step, 16U);
  for (std::size_t i = 0; i < image.label.size(); ++i) {
    std::uint32_t label = 0;
    std::memcpy(&label, &cloud.data[16 * i + 12], 4);
    ASSERT_EQ(label, image.label[i]);
    if (std::isfinite(xyz[3 * i])) {
      ASSERT_EQ(std::memcmp(&cloud.data[16 * i], &xyz[3 * i], 12), 0);
    }
  }
}

TEST_F(RenderProgram, WritesASceneASeedAndTheSameBytesEachTime) {
  ASSERT_EQ(run("medium --count 2 --scale 0.5 " + path("a")), 0) << content("log");
  ASSERT_EQ(run("'medium?seed=2' --scale 0.5 " + path("b")), 0) << content("log");

  EXPECT_TRUE(std::filesystem::exists(path("a/medium1.pcd")));
  EXPECT_EQ(content("a/medium2.pcd"), content("b/medium2.pcd"));
  EXPECT_NE(content("a/medium1.pcd"), content("a/medium2.pcd"));
}

TEST_F(RenderProgram, SaysWhatIsWrongWithTheCommandLine) {
  EXPECT_EQ(run("empty " + path("out")), 2);
  EXPECT_NE(content("log").find("known are simple, medium, crowded"), std::string::npos);
  EXPECT_EQ(run("'simple?seed=4294967295' --count 2 " + path("out")), 2);
  EXPECT_EQ(run("simple --scale 9 " + path("out")), 2);
  EXPECT_EQ(run("simple /proc/nowhere"), 1);
}

}  // namespace
}  // namespace cleave::render
