// SPDX-License-Identifier: BSD-3-Clause
#include "recording/ros/open_frames.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "recording/frames/frame_writer.hpp"
#include "recording/ros/topic_survey.hpp"
#include "tests/unit/recording/recording_files.hpp"
#include "tests/unit/recording/ros/ros_bytes.hpp"

namespace cleave::recording::ros {
namespace {

constexpr std::int64_t ms = 1'000'000;
constexpr std::int64_t start = 1'700'000'000'000 * ms;

ImageSpec image_at(std::int64_t stamp_ns, std::uint16_t depth_mm = 2000) {
  ImageSpec image;
  image.stamp_ns = stamp_ns;
  image.data.clear();
  for (int i = 0; i < 6; ++i) append(image.data, bytes_of_number(depth_mm, false));
  return image;
}

CameraSpec camera_at(std::int64_t stamp_ns, double fx = 50) {
  CameraSpec camera;
  camera.stamp_ns = stamp_ns;
  camera.k[0] = fx;
  return camera;
}

class OpenFrames : public testing::Test {
 protected:
  std::vector<Cloud> read(const std::string& topic = "") {
    const auto input = open_frames({file_, topic}, {Kind::cloud}, "bag");
    std::vector<Cloud> clouds;
    while (auto frame = input->next()) clouds.push_back(std::get<Cloud>(frame->content));
    losses_ = input->losses();
    input->rewind();
    std::size_t again = 0;
    while (input->next()) ++again;
    EXPECT_EQ(again, clouds.size()) << "after a rewind";
    return clouds;
  }
  std::string refusal(const std::string& topic = "") {
    try {
      (void)open_frames({file_, topic}, {Kind::cloud});
    } catch (const FileError& error) {
      return error.what();
    }
    return "";
  }
  void expect_refusal(const std::string& part, const std::string& topic = "") {
    EXPECT_NE(refusal(topic).find(part), std::string::npos) << part << " in: " << refusal(topic);
  }

  TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_.path() / "bag.mcap";
  std::map<std::string, std::uint64_t> losses_;
};

TEST_F(OpenFrames, TakesTheOnlyPointCloud2WithItsHeader) {
  Bag(file_)
      .add("/rosout", "rcl_interfaces/msg/Log", start, Bytes(8))
      .add("/points", cloud_type, start + 5, bytes_of_cloud(cloud_of({1, 2, 3, 4, 5, 6}, 2, 1)))
      .add("/points", cloud_type, start + 9, bytes_of_cloud(cloud_of({7, 8, 9}, 1, 1)))
      .close();
  const std::vector<Cloud> clouds = read();
  ASSERT_EQ(clouds.size(), 2U);
  EXPECT_EQ(clouds[0].xyz, (std::vector<float>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(clouds[0].header.frame_id, 1U);
  EXPECT_EQ(clouds[0].header.sensor, "bag");
  EXPECT_EQ(clouds[0].header.coordinate_frame, "camera_optical");
  EXPECT_EQ(clouds[0].header.capture_time_ns, CloudSpec{}.stamp_ns);
  EXPECT_EQ(clouds[1].xyz, (std::vector<float>{7, 8, 9}));
  EXPECT_EQ(read("points").size(), 2U) << "without the slash";
}

TEST_F(OpenFrames, ReadsNoMoreOfTheFileForATopicThatIsNamedWithoutItsSlash) {
  Bag bag(file_);
  bag.add("/points", cloud_type, start, bytes_of_cloud(cloud_of({1, 2, 3}, 1, 1)));
  std::mt19937 random(1);
  for (int i = 1; i <= 20; ++i) {
    Bytes data(1'000'000);
    for (std::byte& byte : data) byte = std::byte{static_cast<unsigned char>(random())};
    bag.add("/other", "std_msgs/msg/String", start + i, data);
  }
  bag.close();
  if (!bytes_read_so_far()) GTEST_SKIP() << "nobody counts the bytes that are read";
  const auto read_for = [&](const std::string& topic) {
    const std::uint64_t before = *bytes_read_so_far();
    (void)open_frames({file_, topic}, {Kind::cloud});
    return *bytes_read_so_far() - before;
  };
  const std::uint64_t with_slash = read_for("/points");
  EXPECT_LT(with_slash, 10'000'000U);
  EXPECT_LT(read_for("points"), with_slash + 100'000);
}

TEST_F(OpenFrames, PairsImagesWithTheCameraInTheirNamespace) {
  Bag(file_)
      .add("/camera/color/camera_info", camera_type, start, bytes_of_camera(camera_at(start, 99)))
      .add("/camera/depth/image_rect_raw", image_type, start, bytes_of_image(image_at(start)))
      .add("/camera/depth/camera_info", camera_type, start, bytes_of_camera(camera_at(start)))
      .close();
  const std::vector<Cloud> clouds = read();
  ASSERT_EQ(clouds.size(), 1U);
  EXPECT_EQ(clouds[0].header.fx, 50);
  EXPECT_FLOAT_EQ(clouds[0].xyz[0], (0 - 1) / 50.0F * 2);
  EXPECT_FLOAT_EQ(clouds[0].xyz[1], (0 - 0.5F) / 40.0F * 2);
  EXPECT_FLOAT_EQ(clouds[0].xyz[2], 2);
}

TEST_F(OpenFrames, TakesTheCameraOfEachImageOnWhicheverSideItWasRecorded) {
  for (const bool camera_first : {true, false}) {
    Bag bag(file_);
    for (int i = 0; i < 4; ++i) {
      const std::int64_t stamp = start + i * 33 * ms;
      const Bytes camera = bytes_of_camera(camera_at(stamp, 50 + i));
      if (camera_first) bag.add("/depth/camera_info", camera_type, stamp + ms, camera);
      bag.add("/depth/image_raw", image_type, stamp + 2 * ms, bytes_of_image(image_at(stamp)));
      if (!camera_first) bag.add("/depth/camera_info", camera_type, stamp + 3 * ms, camera);
    }
    bag.close();
    const std::vector<Cloud> clouds = read();
    ASSERT_EQ(clouds.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(clouds[i].header.fx, 50 + static_cast<float>(i)) << camera_first;
    }
  }
}

TEST_F(OpenFrames, ReadsBagsConvertedFromRos1) {
  Bag(file_, "ros1")
      .add("/depth/image_raw", "sensor_msgs/Image", start,
           bytes_of_image(image_at(start), Format::ros1))
      .add("/depth/camera_info", "sensor_msgs/CameraInfo", start,
           bytes_of_camera(camera_at(start), Format::ros1))
      .close();
  EXPECT_EQ(read().size(), 1U);
}

TEST_F(OpenFrames, ListsTheTopicsWhereSeveralCanBeSegmented) {
  const Bytes cloud = bytes_of_cloud(CloudSpec{});
  Bag(file_).add("/left", cloud_type, 1, cloud).add("/right", cloud_type, 2, cloud).close();
  expect_refusal("several topics");
  expect_refusal("?topic=/left'");
  expect_refusal("/right (sensor_msgs/msg/PointCloud2, 1 message)");
  EXPECT_EQ(read("/right").size(), 1U);
  expect_refusal("has no topic '/middle'", "/middle");
}

TEST_F(OpenFrames, NamesTheReasonOfEveryTopicThatCannotBe) {
  CloudSpec polar;
  polar.fields = {{"range", 0, 7}};
  ImageSpec picture;
  picture.encoding = "rgb8";
  Bag(file_)
      .add("/polar", cloud_type, 1, bytes_of_cloud(polar))
      .add("/picture", image_type, 2, bytes_of_image(picture))
      .add("/alone/depth", image_type, 3, bytes_of_image(ImageSpec{}))
      .add("/small", "sensor_msgs/msg/CompressedImage", 4, Bytes(8))
      .add("/cut", cloud_type, 5, Bytes(6))
      .close();
  expect_refusal("holds no cloud that can be used");
  expect_refusal("/polar (sensor_msgs/msg/PointCloud2, 1 message): has no field x");
  expect_refusal("its encoding 'rgb8' is not one of depth");
  expect_refusal("no CameraInfo: looked for /alone/camera_info");
  expect_refusal("compressed images are not read");
  expect_refusal("its messages are damaged");
  expect_refusal("has no field x", "/polar");
}

TEST_F(OpenFrames, NamesAnEncodingOfMessagesThatIsNotRead) {
  Bag(file_, "json").add("/points", cloud_type, 1, Bytes(8)).close();
  expect_refusal("its messages are written as 'json'");
}

TEST_F(OpenFrames, CountsFramesThatFailByCause) {
  CloudSpec empty;
  empty.width = 0;
  Bytes cut = bytes_of_cloud(CloudSpec{});
  cut.resize(cut.size() - 20);
  Bag(file_)
      .add("/points", cloud_type, 1, bytes_of_cloud(empty))
      .add("/points", cloud_type, 2, bytes_of_cloud(CloudSpec{}))
      .add("/points", cloud_type, 3, bytes_of_cloud(empty))
      .add("/points", cloud_type, 4, cut)
      .close();
  const std::vector<Cloud> clouds = read();
  ASSERT_EQ(clouds.size(), 1U);
  EXPECT_EQ(clouds[0].header.frame_id, 2U);
  EXPECT_EQ(losses_, (std::map<std::string, std::uint64_t>{{"no points", 2}, {"damaged", 1}}));
}

TEST_F(OpenFrames, GivesTheSamePointsOfOurOwnRecordingsAsOfForeignOnes) {
  {
    FrameWriter writer(file_);
    for (std::uint64_t id = 1; id <= 3; ++id) writer.write({start, depth_cloud(id)});
    writer.close();
  }
  const std::vector<Cloud> ours = read();
  const std::vector<Cloud> theirs = read("cleave/camera/depth/image");
  ASSERT_EQ(theirs.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(same_points(ours[i].xyz, theirs[i].xyz)) << i;
    EXPECT_EQ(ours[i].header.fx, theirs[i].header.fx);
  }
  FrameWriter writer(file_);
  writer.write({start, free_cloud(1)});
  writer.close();
  EXPECT_TRUE(same_points(read()[0].xyz, read("cleave/camera/points")[0].xyz));
}

TEST_F(OpenFrames, PrefersTheCloudsOfCleaveWhereThereAreAny) {
  write_frames(file_, 3, 100'000);
  const std::vector<Cloud> clouds = read();
  ASSERT_EQ(clouds.size(), 3U);
  EXPECT_EQ(clouds[0].header.sensor, "camera");
  EXPECT_EQ(read("cleave/camera/cloud").size(), 3U);
  expect_refusal("goes with the clouds of Cleave", "cleave/camera/labels");
}

TEST(TopicSurvey, SaysThatAnImageIsLargerThanTheStreamCarries) {
  TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "bag.mcap";
  CloudSpec large = cloud_of(std::vector<float>(3 * 1601 * 1200), 1601, 1200);
  Bag(file).add("/points", cloud_type, 1, bytes_of_cloud(large)).close();
  McapReader reader(file);
  TopicSurvey survey;
  while (const auto message = reader.next()) survey.add(*message);
  const std::vector<TopicUse> topics = survey.topics();
  ASSERT_EQ(topics.size(), 1U);
  EXPECT_TRUE(topics[0].usable());
  EXPECT_NE(topics[0].why.find("1601 x 1200 points"), std::string::npos) << topics[0].why;
}

TEST(SplitTopic, PartsAFileFromATopicAtTheLastPlaceWhereOneIsNamed) {
  const auto expect = [](const char* text, const char* file, const char* topic) {
    const FileTopic found = split_topic(text);
    EXPECT_EQ(found.file, file) << text;
    EXPECT_EQ(found.topic, topic) << text;
  };
  expect("bag.mcap", "bag.mcap", "");
  expect("bag.mcap?topic=/a/b", "bag.mcap", "/a/b");
  expect("what?.mcap", "what?.mcap", "");
  expect("what?.mcap?topic=/a", "what?.mcap", "/a");
  expect("a?topic=b.mcap?topic=", "a?topic=b.mcap", "");
}

}  // namespace
}  // namespace cleave::recording::ros
