// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/sources/pcd_source.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "recording/pcd/folder.hpp"
#include "tests/support/data_folder.hpp"
#include "tests/unit/recording/pcd/pcd_files.hpp"

namespace cleave::sensor {
namespace {

using recording::TestFolder;
using std::chrono::seconds;

std::string cloud_at(float x) {
  return recording::binary_file({x, 2, 3}, 1, 1);
}

// The x of the first point of every frame, up to `most`.
std::vector<float> play(Source& source, std::size_t most = 100) {
  std::vector<float> xs;
  Frame frame;
  std::vector<float> xyz(3 * capacity_points);
  while (xs.size() < most && source.next(seconds(10), frame) == Poll::frame) {
    source.write_points(xyz.data());
    xs.push_back(xyz[0]);
  }
  return xs;
}

TEST(PcdSource, PlaysAFolderInNaturalOrder) {
  const TestFolder folder;
  folder.write("scene10.pcd", cloud_at(10));
  folder.write("scene9.pcd", cloud_at(9));
  folder.write("scene1.pcd", cloud_at(1));
  PcdSource source(folder.path(), false);
  ASSERT_FALSE(source.open());
  EXPECT_EQ(play(source), (std::vector<float>{1, 9, 10}));
  EXPECT_FALSE(source.realtime());
}

TEST(PcdSource, PlaysASingleFile) {
  const TestFolder folder;
  PcdSource source(folder.write("one.pcd", cloud_at(5)), false);
  ASSERT_FALSE(source.open());
  EXPECT_EQ(play(source), (std::vector<float>{5}));
}

// A camera's view, `scale` units a metre.
std::string image(float scale) {
  std::vector<float> xyz;
  for (int i = 0; i < 40 * 30; ++i) {
    const auto u = static_cast<float>(i % 40), v = static_cast<float>(i / 40);
    const float z = scale * (0.7F + 0.01F * v);
    xyz.insert(xyz.end(), {z * (u - 20) / 60, z * (v - 15) / 60, z});
  }
  return recording::binary_file(xyz, 40, 30);
}

TEST(PcdSource, RefusesFilesThatAreSeenToBeInMillimetres) {
  const TestFolder folder;
  folder.write("mm.pcd", image(1000));
  PcdSource source(folder.path(), false);

  const Failure failure = source.open();

  ASSERT_TRUE(failure);
  EXPECT_NE(failure->find("1 wrong unit"), std::string::npos) << *failure;
}

TEST(PcdSource, ScalesFilesByTheUnitThatIsGiven) {
  const TestFolder folder;
  PcdSource millimetres(folder.write("mm.pcd", image(1000)), false, recording::Unit::millimetre);
  PcdSource metres(folder.write("m.pcd", image(1000)), false, recording::Unit::metre);
  ASSERT_FALSE(millimetres.open());
  ASSERT_FALSE(metres.open());

  EXPECT_NEAR(play(millimetres).at(0), 0.7F * -20 / 60, 1e-6);
  EXPECT_NEAR(play(metres).at(0), 700.0F * -20 / 60, 1e-3);
}

TEST(PcdSource, SkipsAndCountsBadFilesAmongGoodOnes) {
  const TestFolder folder;
  folder.write("1.pcd", cloud_at(1));
  folder.write("2.pcd", "");
  std::string truncated = cloud_at(3);
  truncated.pop_back();
  folder.write("3.pcd", truncated);
  folder.write("4.txt", "notes");
  folder.write("5.pcd", cloud_at(5));
  PcdSource source(folder.path(), false);
  ASSERT_FALSE(source.open());
  EXPECT_EQ(play(source), (std::vector<float>{1, 5}));
  const std::map<std::string, std::uint64_t> expected = {
      {"not PCD", 1}, {"truncated", 1}, {"wrong extension", 1}};
  EXPECT_EQ(source.counts().unusable, expected);
}

TEST(PcdSource, BeginsAnEpochWithEveryFurtherPass) {
  const TestFolder folder;
  folder.write("1.pcd", cloud_at(1));
  folder.write("2.pcd", cloud_at(2));
  PcdSource source(folder.path(), true);
  ASSERT_FALSE(source.open());
  std::vector<bool> begins;
  Frame frame;
  for (int i = 0; i < 6; ++i) {
    ASSERT_EQ(source.next(seconds(10), frame), Poll::frame);
    begins.push_back(frame.begins_epoch);
  }
  EXPECT_EQ(begins, (std::vector<bool>{false, false, true, false, true, false}));
}

TEST(PcdSource, CountsABadFileOnceHoweverOftenItLoops) {
  const TestFolder folder;
  folder.write("1.pcd", cloud_at(1));
  folder.write("2.pcd", "");
  PcdSource source(folder.path(), true);
  ASSERT_FALSE(source.open());
  EXPECT_EQ(play(source, 10).size(), 10U);
  EXPECT_EQ(source.counts().unusable.at("not PCD"), 1U);
}

TEST(PcdSource, SaysWhatItLookedForWhenNothingIsUsable) {
  const TestFolder folder;
  folder.write("2.pcd", "");
  folder.write("notes.txt", "");
  PcdSource source(folder.path(), false);
  const Failure failure = source.open();
  ASSERT_TRUE(failure);
  EXPECT_NE(failure->find("*.pcd in " + folder.path().string()), std::string::npos) << *failure;
  EXPECT_NE(failure->find("1 not PCD, 1 wrong extension"), std::string::npos) << *failure;
}

TEST(PcdSource, SaysThatAFolderIsEmptyOrMissing) {
  const TestFolder folder;
  EXPECT_NE(PcdSource(folder.path(), false).open()->find("there is no file"), std::string::npos);
  EXPECT_NE(PcdSource(folder.path() / "nowhere", false).open()->find("no such file or folder"),
            std::string::npos);
}

TEST(PcdSource, NamesAFolderThatPosesAsAFileAndPassesOverOthers) {
  const TestFolder folder;
  std::filesystem::create_directory(folder.path() / "folder.pcd");
  std::filesystem::create_directory(folder.path() / "more");
  const recording::PcdFiles found = recording::list_pcd_files(folder.path());
  ASSERT_EQ(found.files.size(), 1U);
  EXPECT_EQ(found.files[0].filename(), "folder.pcd");
  EXPECT_TRUE(found.others.empty());
}

TEST(PcdLoader, ReadsFilesAnewThatDoNotFitIntoItsMemory) {
  const TestFolder folder;
  const auto file = folder.write("1.pcd", cloud_at(1));
  PcdLoader loader({file}, true, {}, capacity_points, 0);
  LoadedCloud first{}, second{};
  ASSERT_EQ(loader.next(seconds(10), first), PcdLoader::Result::item);
  ASSERT_EQ(loader.next(seconds(10), second), PcdLoader::Result::item);
  EXPECT_NE(first.cloud, second.cloud);
  EXPECT_EQ(first.cloud->xyz, second.cloud->xyz);
}

TEST(PcdLoader, KeepsWhatFits) {
  const TestFolder folder;
  const auto file = folder.write("1.pcd", cloud_at(1));
  PcdLoader loader({file}, true);
  LoadedCloud first{}, second{};
  ASSERT_EQ(loader.next(seconds(10), first), PcdLoader::Result::item);
  ASSERT_EQ(loader.next(seconds(10), second), PcdLoader::Result::item);
  EXPECT_EQ(first.cloud, second.cloud);
}

TEST(PcdSource, PlaysRealScenesWithTheIntrinsicsOfTheirCamera) {
  const auto scene = tests::find_data("mosd/learn/learn0.pcd");
  if (!scene) GTEST_SKIP() << "data/mosd/learn is not here: set CLEAVE_DATA";
  PcdSource source(*scene, false);
  ASSERT_FALSE(source.open());
  Frame frame;
  ASSERT_EQ(source.next(seconds(10), frame), Poll::frame);
  EXPECT_EQ(frame.width, 640U);
  EXPECT_EQ(frame.height, 480U);
  EXPECT_NEAR(frame.intrinsics.fx, 525, 0.01);
  EXPECT_NEAR(frame.intrinsics.cy, 239.5, 0.01);
}

}  // namespace
}  // namespace cleave::sensor
