// SPDX-License-Identifier: BSD-3-Clause
// A bag of ROS 2 through convert, verify and segment, as our own recordings go.
#include <gtest/gtest.h>

#include "cleave/commands/convert_command.hpp"
#include "console/json.hpp"
#include "recording/error.hpp"
#include "recording/pcd/cloud.hpp"
#include "tests/support/run_command.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/recording/recording_files.hpp"
#include "tests/unit/recording/ros/ros_bytes.hpp"
#include "workbench/commands/segment_command.hpp"
#include "workbench/verification/verification.hpp"

namespace cleave::workbench {
namespace {

namespace fs = std::filesystem;
using recording::PcdCloud;
using recording::ros::Bag;
using recording::ros::bytes_of_cloud;
using recording::ros::cloud_of;

class ForeignBag : public testing::Test {
 protected:
  ForeignBag() {
    Bag bag(bag_);
    for (std::uint64_t id = 1; id <= 3; ++id) {
      const recording::Cloud cloud = recording::depth_cloud(id);
      bag.add("/points", recording::ros::cloud_type, static_cast<std::int64_t>(id) * 1000,
              bytes_of_cloud(cloud_of(cloud.xyz, 32, 24)));
    }
    bag.add("/rosout", "rcl_interfaces/msg/Log", 5000, recording::Bytes(8)).close();
  }
  [[nodiscard]] std::size_t update(const fs::path& input) const {
    OfflineSegmenter segmenter({}, 2);
    return write_golden({input}, golden_, segmenter, [](std::size_t) {});
  }

  tests::TemporaryFolder folder_;
  const fs::path bag_ = folder_.path() / "bag.mcap";
  const fs::path flat_ = folder_.path() / "flat.mcap";
  const fs::path golden_ = folder_.path() / "golden.mcap";
  const fs::path out_ = folder_.path() / "out";
};

TEST_F(ForeignBag, IsConvertedToPcdAndToARecordingOfOurs) {
  EXPECT_EQ(tests::run_command(client::add_convert_command, {"convert", bag_, out_}), exit_done);
  const PcdCloud pcd = PcdCloud::read(out_ / "frame_000003.pcd");
  const recording::Cloud expected = recording::depth_cloud(3);
  EXPECT_TRUE(recording::same_points({pcd.xyz().begin(), pcd.xyz().end()}, expected.xyz));
  const std::string ours = folder_.path() / "ours.mcap";
  EXPECT_EQ(tests::run_command(client::add_convert_command,
                               {"convert", "mcap:" + bag_.string() + "?topic=/points", ours}),
            exit_done);
  const std::vector<recording::Frame> frames = recording::read_frames(ours);
  ASSERT_EQ(frames.size(), 3U);
  EXPECT_EQ(frames[0].header().sensor, "camera");
}

TEST_F(ForeignBag, IsNoGoldenFileWhereACloudIsTooLargeAndSaysWhatHelps) {
  const fs::path large = folder_.path() / "large.mcap";
  const std::vector<float> xyz(std::size_t{3} * 1601 * 1200, 1.0F);
  Bag(large)
      .add("/points", recording::ros::cloud_type, 1000, bytes_of_cloud(cloud_of(xyz, 1601, 1200)))
      .close();
  try {
    (void)update(large);
    FAIL() << "a golden file without it would prove nothing of it";
  } catch (const recording::FileError& error) {
    const std::string why = error.what();
    EXPECT_NE(why.find("1601 x 1200"), std::string::npos) << why;
    EXPECT_NE(why.find("--decimate 2"), std::string::npos) << why;
    EXPECT_EQ(why.find("recover"), std::string::npos) << why;
  }
  EXPECT_FALSE(fs::exists(golden_));
}

TEST_F(ForeignBag, LeavesOutWhatARecordingCannotHoldAndKeepsNoEmptyFile) {
  const fs::path large = folder_.path() / "large.mcap";
  Bag(large)
      .add("/points", recording::ros::cloud_type, 1,
           bytes_of_cloud(cloud_of(std::vector<float>(3 * 1601 * 1200, 1), 1601, 1200)))
      .close();
  EXPECT_EQ(tests::run_command(client::add_convert_command,
                               {"convert", large, folder_.path() / "ours.mcap"}),
            exit_failed);
  EXPECT_FALSE(fs::exists(folder_.path() / "ours.mcap"));
  EXPECT_EQ(tests::run_command(client::add_convert_command, {"convert", large, out_}), exit_done);
  EXPECT_THROW((void)update(large), recording::FileError);
  EXPECT_FALSE(fs::exists(golden_));
}

TEST_F(ForeignBag, IsVerifiedAgainstItsGoldenFile) {
  EXPECT_EQ(update(bag_), 3U);
  OfflineSegmenter segmenter({}, 2);
  const VerificationResult result = verify(
      {bag_, "/points"}, golden_, segmenter, {}, [](const FrameDifference&) {}, [](std::size_t) {});
  EXPECT_TRUE(result.passed());
  EXPECT_EQ(result.frames, 3U);
}

TEST_F(ForeignBag, OfNothingUsableMakesNoGoldenFileAndSaysWhy) {
  Bag(bag_).add("/rosout", "rcl_interfaces/msg/Log", 1, recording::Bytes(8)).close();
  try {
    (void)update(bag_);
    FAIL() << "a golden file of no frames";
  } catch (const recording::FileError& error) {
    EXPECT_NE(std::string(error.what()).find("/rosout"), std::string::npos) << error.what();
  }
  EXPECT_FALSE(fs::exists(golden_));
}

TEST_F(ForeignBag, IsSegmentedIntoALabelledPcdFileAFrame) {
  EXPECT_EQ(tests::run_command(add_segment_command, {"segment", bag_, out_, "--json"}), exit_done);
  for (const char* const name : {"frame_000001.pcd", "frame_000002.pcd", "frame_000003.pcd"}) {
    EXPECT_TRUE(PcdCloud::read(out_ / name).header().find("label")) << name;
  }
}

TEST_F(ForeignBag, TellsOfEachFrameWhatIsToldOfAFile) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(tests::run_command(add_segment_command, {"segment", bag_, out_, "--json"}), exit_done);
  const Json frame = Json::parse(testing::internal::GetCapturedStdout())["frames"][1];
  const fs::path pcd = folder_.path() / "second.pcd";
  testing::internal::CaptureStdout();
  EXPECT_EQ(
      tests::run_command(add_segment_command, {"segment", bag_, pcd, "--frame", "2", "--json"}),
      exit_done);
  const Json alone = Json::parse(testing::internal::GetCapturedStdout());
  for (const char* const key : {"points", "segments", "borders"}) {
    ASSERT_TRUE(frame.contains(key)) << key;
    EXPECT_EQ(frame[key], alone[key]) << key;
  }
}

TEST_F(ForeignBag, IsSegmentedFromTheViewpointThatIsNamed) {
  const fs::path seen_from_behind = folder_.path() / "behind";
  const auto normals_of = [this](const fs::path& out, std::vector<std::string> more) {
    std::vector<std::string> words = {"segment", flat_, out, "--json"};
    words.insert(words.end(), more.begin(), more.end());
    testing::internal::CaptureStdout();
    EXPECT_EQ(tests::run_command(add_segment_command, words), exit_done);
    const Json json = Json::parse(testing::internal::GetCapturedStdout());
    return json["frames"][0]["segments"][0]["mean_normal"];
  };
  // Points in no order, as a map has them: only a viewpoint says which side was seen.
  std::vector<float> xyz;
  for (int i = 0; i < 1200; ++i) {
    for (const int value : {i % 40, i / 40, 200}) xyz.push_back(0.005F * static_cast<float>(value));
  }
  Bag(flat_)
      .add("/points", recording::ros::cloud_type, 1, bytes_of_cloud(cloud_of(xyz, 1200, 1)))
      .close();
  EXPECT_LT(normals_of(out_, {"--viewpoint", "0,0,0"})[2], 0);
  EXPECT_GT(normals_of(seen_from_behind, {"--viewpoint", "0,0,3"})[2], 0);
}

TEST_F(ForeignBag, GivesOneFrameWhereOneIsAskedFor) {
  const fs::path pcd = folder_.path() / "second.pcd";
  EXPECT_EQ(tests::run_command(add_segment_command, {"segment", bag_, pcd, "--frame", "2"}),
            exit_done);
  const PcdCloud cloud = PcdCloud::read(pcd);
  EXPECT_TRUE(recording::same_points({cloud.xyz().begin(), cloud.xyz().end()},
                                     recording::depth_cloud(2).xyz));
  EXPECT_THROW(
      (void)tests::run_command(add_segment_command, {"segment", bag_, pcd, "--frame", "4"}),
      std::runtime_error);
  EXPECT_THROW(
      (void)tests::run_command(add_segment_command, {"segment", bag_, out_, "--frame", "2"}),
      UsageError);
}

}  // namespace
}  // namespace cleave::workbench
