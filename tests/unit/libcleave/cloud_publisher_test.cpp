// SPDX-License-Identifier: BSD-3-Clause
// Your own camera, over the network path.
#include "libcleave/cloud_publisher.hpp"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <thread>
#include <vector>

#include "libcleave/cloud_reader.hpp"
#include "libcleave/reader.hpp"
#include "libcleave/status.hpp"

namespace cleave {
namespace {

class OwnCamera : public testing::Test {
 protected:
  static bool eventually(const std::function<bool()>& condition) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (!condition()) {
      if (std::chrono::steady_clock::now() > end) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return true;
  }
  // Of 4 x 2 points; its principal point is pixel (1, 1).
  static CloudSettings settings() {
    CloudSettings s;
    s.width = 4;
    s.height = 2;
    s.fx = s.fy = 2;
    s.cx = s.cy = 1;
    s.parent_frame = "base_link";
    s.position = {1, 2, 3};
    s.orientation = {0, 0, 0, 1};
    return s;
  }
  std::optional<CloudSample> received() {
    std::optional<CloudSample> cloud;
    (void)eventually([&] { return (cloud = reader_.take()).has_value(); });
    return cloud;
  }
  void open() {
    publisher_ = std::make_unique<CloudPublisher>(stream_, settings());
    ASSERT_TRUE(eventually([&] { return publisher_->readers() == 1; }));
  }

  Stream stream_{{.domain = 32, .shared_memory = false}};
  CloudReader reader_{stream_, "camera"};
  std::unique_ptr<CloudPublisher> publisher_;
};

TEST_F(OwnCamera, TurnsADepthImageIntoPoints) {
  open();
  const std::array<std::uint16_t, 8> depth = {1000, 1000, 1000, 1000, 0, 2000, 2000, 2000};
  ASSERT_TRUE(publisher_->publish_depth(depth, 0.001F, 77));
  const auto cloud = received();
  ASSERT_TRUE(cloud);
  ASSERT_EQ(cloud->xyz().size(), 24U);
  EXPECT_FLOAT_EQ(cloud->xyz()[0], -0.5F);
  EXPECT_FLOAT_EQ(cloud->xyz()[1], -0.5F);
  EXPECT_FLOAT_EQ(cloud->xyz()[2], 1);
  for (std::size_t i = 12; i < 15; ++i) EXPECT_TRUE(std::isnan(cloud->xyz()[i]));
  EXPECT_FLOAT_EQ(cloud->xyz()[21], 2);
  EXPECT_FLOAT_EQ(cloud->xyz()[23], 2);
  EXPECT_EQ(cloud->header().capture_time_ns, 77);
}

TEST_F(OwnCamera, TakesMetresAsMillimetresButForRounding) {
  open();
  const std::array<float, 8> depth = {1, 1, 1, 1, 0, 2, std::numeric_limits<float>::quiet_NaN(), 2};
  ASSERT_TRUE(publisher_->publish_depth(depth));
  const auto cloud = received();
  ASSERT_TRUE(cloud);
  EXPECT_FLOAT_EQ(cloud->xyz()[0], -0.5F);
  for (std::size_t i = 12; i < 15; ++i) EXPECT_TRUE(std::isnan(cloud->xyz()[i]));
  for (std::size_t i = 18; i < 21; ++i) EXPECT_TRUE(std::isnan(cloud->xyz()[i]));
}

TEST_F(OwnCamera, TellsItsNamesAndItsPoseInEveryHeader) {
  open();
  const std::vector<float> xyz(24, 1);
  ASSERT_TRUE(publisher_->publish_points(xyz));
  ASSERT_TRUE(publisher_->publish_points(xyz));
  for (std::uint64_t id = 1; id <= 2; ++id) {
    const auto cloud = received();
    ASSERT_TRUE(cloud);
    const FrameHeader& header = cloud->header();
    EXPECT_EQ(header.frame_id, id);
    EXPECT_EQ(name_of(header.sensor), "camera");
    EXPECT_EQ(name_of(header.coordinate_frame), "camera_optical");
    EXPECT_EQ(name_of(header.parent_frame), "base_link");
    EXPECT_EQ(header.pose.position.z, 3);
    EXPECT_EQ(header.pose.orientation.w, 1);
    EXPECT_NE(header.capture_time_ns, 0);
  }
}

TEST_F(OwnCamera, LendsTheMemoryThatIsPublished) {
  open();
  std::optional<CloudLoan> loan = publisher_->loan();
  ASSERT_TRUE(loan);
  for (std::size_t i = 0; i < 24; ++i) loan->room()[i] = static_cast<float>(i);
  ASSERT_TRUE(publisher_->publish(std::move(*loan)));
  const auto cloud = received();
  ASSERT_TRUE(cloud);
  EXPECT_EQ(cloud->xyz().back(), 23);
}

TEST_F(OwnCamera, IsItsSensorsGrabberToAllWhoReadTheStatus) {
  Reader<NodeStatus> statuses(stream_, "");
  NodeReport last;
  const auto state_is = [&](NodeState state) {
    while (const auto sample = statuses.take()) last = report_of(**sample);
    return last.node == "grabber/camera" && last.state == state;
  };
  open();
  EXPECT_TRUE(eventually([&] { return state_is(NodeState::running); }));
  ASSERT_TRUE(publisher_->publish_points(std::vector<float>(24, 1)));
  publisher_.reset();
  EXPECT_TRUE(eventually([&] { return state_is(NodeState::ended); }));
  EXPECT_EQ(last.frames_out, 1U);
  EXPECT_EQ(last.contract, contract_name);
}

TEST_F(OwnCamera, RefusesAFrameOfAnotherSize) {
  open();
  EXPECT_THROW(publisher_->publish_points(std::vector<float>(23)), std::invalid_argument);
  EXPECT_THROW(publisher_->publish_depth(std::vector<float>(9)), std::invalid_argument);
  EXPECT_THROW(publisher_->publish_depth(std::vector<std::uint16_t>(7), 0.001F),
               std::invalid_argument);
}

TEST_F(OwnCamera, RefusesDepthWithoutIntrinsics) {
  CloudSettings s = settings();
  s.fx = s.fy = s.cx = s.cy = 0;
  CloudPublisher publisher(stream_, s);
  EXPECT_THROW(publisher.publish_depth(std::vector<float>(8)), std::invalid_argument);
}

TEST_F(OwnCamera, RefusesSettingsThatCannotBe) {
  const auto refuses = [&](const std::function<void(CloudSettings&)>& spoil) {
    CloudSettings s = settings();
    spoil(s);
    EXPECT_THROW(CloudPublisher(stream_, s), std::invalid_argument);
  };
  refuses([](CloudSettings& s) { s.sensor = "two words"; });
  refuses([](CloudSettings& s) { s.height = 0; });
  refuses([](CloudSettings& s) { s.width = s.height = 65536; });
  refuses([](CloudSettings& s) { s.fx = -1; });
  refuses([](CloudSettings& s) { s.fy = std::numeric_limits<float>::infinity(); });
  refuses([](CloudSettings& s) { s.orientation = {0, 0, 0, 2}; });
  refuses([](CloudSettings& s) { s.orientation = {}; });
  refuses([](CloudSettings& s) { s.parent_frame.clear(); });
  refuses([](CloudSettings& s) { s.coordinate_frame = std::string(64, 'x'); });
}

TEST_F(OwnCamera, IsTheOnlyPublisherOfItsSensor) {
  open();
  EXPECT_THROW(CloudPublisher(stream_, settings()), std::runtime_error);
}

}  // namespace
}  // namespace cleave
