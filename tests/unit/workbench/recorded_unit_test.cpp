// SPDX-License-Identifier: BSD-3-Clause
// Recordings and files in millimetres through every command that reads clouds.
#include <gtest/gtest.h>

#include "cleave/commands/convert_command.hpp"
#include "recording/pcd/cloud.hpp"
#include "recording/pcd/writer.hpp"
#include "recording/units/suspected_unit.hpp"
#include "tests/support/run_command.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/recording/oni/oni_file.hpp"
#include "tests/unit/recording/recording_files.hpp"
#include "tests/unit/recording/ros/ros_bytes.hpp"
#include "workbench/commands/segment_command.hpp"
#include "workbench/commands/verify_command.hpp"

namespace cleave::workbench {
namespace {

namespace fs = std::filesystem;
using recording::PcdCloud;
using recording::WrongUnit;
using Words = std::vector<std::string>;

constexpr std::uint32_t width = 40;
constexpr std::uint32_t height = 30;

// A camera's view of a slope, `scale` units a metre.
std::vector<float> slope(double scale) {
  std::vector<float> xyz;
  for (std::uint32_t row = 0; row < height; ++row) {
    for (std::uint32_t column = 0; column < width; ++column) {
      const double z = scale * (0.7 + 0.001 * row);
      for (const double value : {z * (column - 20.0) / 500, z * (row - 15.0) / 500, z}) {
        xyz.push_back(static_cast<float>(value));
      }
    }
  }
  return xyz;
}

std::vector<float> in_metres(std::vector<float> millimetres) {
  recording::scale_to_metres(millimetres, recording::Unit::millimetre);
  return millimetres;
}

std::vector<float> pcd_points(const fs::path& pcd) {
  const PcdCloud cloud = PcdCloud::read(pcd);
  return {cloud.xyz().begin(), cloud.xyz().end()};
}

class RecordedUnit : public testing::Test {
 protected:
  // A bag whose clouds have these points, one after the other.
  void write_bag(const std::vector<std::vector<float>>& clouds) const {
    recording::ros::Bag bag(bag_);
    std::int64_t time_ns = 0;
    for (const auto& xyz : clouds) {
      bag.add("/points", recording::ros::cloud_type, ++time_ns,
              bytes_of_cloud(recording::ros::cloud_of(xyz, width, height)));
    }
    bag.close();
  }
  [[nodiscard]] int convert(Words words) const {
    words.insert(words.begin(), "convert");
    return tests::run_command(client::add_convert_command, std::move(words));
  }
  [[nodiscard]] int segment(Words words) const {
    words.insert(words.begin(), "segment");
    return tests::run_command(add_segment_command, std::move(words));
  }
  [[nodiscard]] int verify(Words words) const {
    words.insert(words.begin(), {"verify", "--workers", "2"});
    return tests::run_command(add_verify_command, std::move(words));
  }

  tests::TemporaryFolder folder_;
  const fs::path bag_ = folder_.path() / "bag.mcap";
  const fs::path out_ = folder_.path() / "out";
  const fs::path mcap_ = folder_.path() / "out.mcap";
};

TEST_F(RecordedUnit, ConvertingMillimetreFilesWritesNothingSoThatItsAdviceCanBeFollowed) {
  write_pcd(folder_.path() / "mm.pcd", PcdCloud::of_points(slope(1000), width, height));
  EXPECT_EQ(convert({folder_.path(), mcap_}), exit_failed);
  EXPECT_FALSE(fs::exists(mcap_));
  EXPECT_EQ(convert({folder_.path(), mcap_, "--unit", "mm"}), exit_done);
}

TEST_F(RecordedUnit, OneFileInMillimetresDoesNotCostTheOthersOfItsFolder) {
  fs::create_directory(out_);
  write_pcd(out_ / "1.pcd", PcdCloud::of_points(slope(1000), width, height));
  write_pcd(out_ / "2.pcd", PcdCloud::of_points(slope(1), width, height));
  EXPECT_EQ(convert({out_, mcap_}), exit_failed);
  const auto frames = recording::read_frames(mcap_);
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_TRUE(recording::same_points(std::get<recording::Cloud>(frames[0].content).xyz, slope(1)));
}

TEST_F(RecordedUnit, ARecordingInMillimetresIsRefusedAndNothingIsWritten) {
  write_bag({slope(1000), slope(1000)});
  EXPECT_THROW((void)convert({bag_, mcap_}), WrongUnit);
  EXPECT_THROW((void)segment({bag_, out_}), WrongUnit);
  EXPECT_THROW((void)segment({bag_, folder_.path() / "1.pcd", "--frame", "1"}), WrongUnit);
  try {
    (void)verify({bag_, "--expect", mcap_, "--update"});
    FAIL() << "verify takes millimetres for metres";
  } catch (const WrongUnit& error) {
    EXPECT_NE(std::string(error.what()).find(bag_), std::string::npos) << error.what();
  }
  EXPECT_FALSE(fs::exists(mcap_));
  EXPECT_FALSE(fs::exists(out_));
}

TEST_F(RecordedUnit, ARecordingInMillimetresIsScaledWhereItsUnitIsNamed) {
  write_bag({slope(1000), slope(1000)});
  const std::vector<float> metres = in_metres(slope(1000));
  EXPECT_EQ(convert({bag_, mcap_, "--unit", "mm"}), exit_done);
  for (const recording::Frame& frame : recording::read_frames(mcap_)) {
    EXPECT_TRUE(recording::same_points(std::get<recording::Cloud>(frame.content).xyz, metres));
  }
  EXPECT_EQ(segment({bag_, out_, "--unit", "mm"}), exit_done);
  EXPECT_TRUE(recording::same_points(pcd_points(out_ / "frame_000002.pcd"), metres));
  const fs::path one = folder_.path() / "1.pcd";
  EXPECT_EQ(segment({bag_, one, "--frame", "1", "--unit", "mm"}), exit_done);
  EXPECT_TRUE(recording::same_points(pcd_points(one), metres));
}

TEST_F(RecordedUnit, ARecordingIsVerifiedInItsUnitAsIfItHadBeenConverted) {
  write_bag({slope(1000), slope(1000)});
  const fs::path golden = folder_.path() / "golden.mcap";
  EXPECT_EQ(convert({bag_, mcap_, "--unit", "mm"}), exit_done);
  EXPECT_EQ(verify({mcap_, "--expect", golden, "--update"}), exit_done);
  const auto segments = recording::read_frames(golden);
  EXPECT_EQ(std::get<recording::SegmentList>(segments.back().content).segments.size(), 1U);
  EXPECT_EQ(verify({bag_, "--expect", golden, "--unit", "mm"}), exit_done);
  EXPECT_EQ(verify({bag_, "--expect", golden, "--unit", "m"}), exit_failed);
}

TEST_F(RecordedUnit, TheFirstCloudAloneIsAskedSoThatALaterOneEndsNoRun) {
  write_bag({slope(1), slope(1000), slope(1)});
  EXPECT_EQ(convert({bag_, mcap_}), exit_done);
  EXPECT_EQ(recording::read_frames(mcap_).size(), 3U);
  EXPECT_EQ(segment({bag_, out_}), exit_done);
  EXPECT_TRUE(fs::exists(out_ / "frame_000003.pcd"));
}

TEST_F(RecordedUnit, RecordedSegmentsAreScaledWithTheirClouds) {
  recording::write_frames(bag_, 1, 4096);
  const recording::SegmentList before = recording::segment_list(1);
  EXPECT_EQ(convert({bag_, mcap_, "--unit", "cm"}), exit_done);
  const auto frames = recording::read_frames(mcap_);
  const auto& after = std::get<recording::SegmentList>(frames.back().content);
  ASSERT_EQ(after.segments.size(), before.segments.size());
  EXPECT_FLOAT_EQ(after.segments[0].centroid.z, before.segments[0].centroid.z / 100);
  EXPECT_FLOAT_EQ(after.segments[0].box.extent.x, before.segments[0].box.extent.x / 100);
  EXPECT_EQ(after.segments[0].mean_normal, before.segments[0].mean_normal);
}

TEST_F(RecordedUnit, AnOniFileHasAUnitOfItsOwnAndIsGivenNone) {
  oni::test::OniFile recording;
  recording.frames = {oni::test::example_image(recording.width, recording.height, 1)};
  const fs::path oni = folder_.file("a.oni", recording.bytes());
  EXPECT_THROW((void)convert({oni, mcap_, "--unit", "mm"}), recording::UnknownInput);
  EXPECT_THROW((void)segment({oni, out_, "--unit", "mm"}), recording::UnknownInput);
}

}  // namespace
}  // namespace cleave::workbench
