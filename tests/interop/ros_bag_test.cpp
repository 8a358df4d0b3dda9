// SPDX-License-Identifier: BSD-3-Clause
// A rendered scene in a bag of ROS 2 that MCAP's own writer and Foxglove's own serialisation made:
// as PointCloud2, as 16UC1 and as 32FC1 it has the same segments.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <span>

#include "recording/error.hpp"
#include "recording/ros/open_frames.hpp"
#include "segmentation/segmenter.hpp"
#include "sensor/renderer/scene/scene_loop.hpp"
#include "tests/integration/support/process.hpp"
#include "tests/interop/npm_packages.hpp"
#include "tests/unit/recording/recording_files.hpp"

namespace cleave::test {
namespace {

namespace fs = std::filesystem;
using Labels = std::vector<std::uint16_t>;

// Of the points that have a label in either, the share that the best partner of their segment in
// `a` has.
double covered(const Labels& a, const Labels& b) {
  std::map<std::uint16_t, std::map<std::uint16_t, std::size_t>> overlaps;
  std::size_t total = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == 0 && b[i] == 0) continue;
    ++overlaps[a[i]][b[i]];
    ++total;
  }
  std::size_t agreed = 0;
  for (const auto& [label, partners] : overlaps) {
    std::size_t best = 0;
    for (const auto& [partner, count] : partners) best = std::max(best, count);
    agreed += best;
  }
  return static_cast<double>(agreed) / static_cast<double>(total);
}

// Neither has segments that are parts of the other's, or several of them in one.
double agreement(const Labels& a, const Labels& b) {
  return std::min(covered(a, b), covered(b, a));
}

class RosBag : public testing::Test {
 protected:
  void SetUp() override {
    const fs::path packages = CLEAVE_MCAP_MODULES;
    install_npm_packages(CLEAVE_MCAP_INTEROP, packages);
    const fs::path script = packages / "write_ros_bag.mjs";
    fs::copy_file(fs::path(CLEAVE_MCAP_INTEROP) / "write_ros_bag.mjs", script,
                  fs::copy_options::overwrite_existing);
    const render::LabelledDepth scene =
        render::SceneLoop(render::parse_scene("medium?seed=3")).frame(0);
    const fs::path depth = files_.path() / "depth";
    recording::write_all(depth, std::as_bytes(std::span(scene.depth_mm)));
    Process writer({"/usr/bin/env", "node", script.string(), depth.string(), bag_.string(),
                    std::to_string(scene.width), std::to_string(scene.height), "525", "525",
                    "319.5", "239.5"});
    ASSERT_EQ(writer.wait(), 0) << writer.log();
  }

  [[nodiscard]] Labels segment(const std::string& topic) const {
    const auto input = recording::open_frames({bag_, topic}, {recording::Kind::cloud});
    const auto frame = input->next();
    EXPECT_TRUE(frame) << topic;
    const auto& cloud = std::get<recording::Cloud>(frame->content);
    EXPECT_EQ(cloud.header.coordinate_frame, "camera_depth_optical_frame");
    EXPECT_EQ(cloud.header.capture_time_ns, 1'700'000'000'500'000'000);
    EXPECT_NEAR(cloud.header.fx, 525, 0.01) << topic;
    Labels labels(cloud.header.points());
    segmentation::Segmenter segmenter;
    segmentation::Segmentation result;
    const segmentation::CloudView view{.xyz = cloud.xyz.data(),
                                       .stride = 3,
                                       .width = cloud.header.width,
                                       .height = cloud.header.height};
    EXPECT_EQ(segmenter.segment(view, labels, result), segmentation::Outcome::segmented);
    EXPECT_GT(result.segments.size(), 5U);
    return labels;
  }

  const TemporaryFolder files_;
  const fs::path bag_ = files_.path() / "bag.mcap";
};

TEST_F(RosBag, HasTheSameSegmentsInEveryOneOfItsMessages) {
  const Labels image = segment("/camera/depth/image_rect_raw");
  EXPECT_GT(agreement(image, segment("/zed/depth/depth_registered")), 0.995);
  EXPECT_GT(agreement(image, segment("/camera/depth/points")), 0.995);
}

TEST_F(RosBag, NamesItsTopicsWhereNoneIsNamed) {
  try {
    (void)recording::open_frames({bag_, ""}, {recording::Kind::cloud});
    FAIL() << "three topics can be segmented";
  } catch (const recording::FileError& error) {
    const std::string text = error.what();
    for (const char* const topic :
         {"/camera/depth/image_rect_raw", "/camera/depth/points", "/zed/depth/depth_registered"}) {
      EXPECT_NE(text.find(topic), std::string::npos) << text;
    }
    EXPECT_EQ(text.find("/camera/color/image_raw"), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace cleave::test
