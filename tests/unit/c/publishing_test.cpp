// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "tests/unit/c/c_stream.hpp"

namespace cleave {
namespace {

class PublisherOfC : public test::CStream {
 protected:
  PublisherOfC() : reader_(reader(CLEAVE_CLOUD)), publisher_(publisher()) {}
  ~PublisherOfC() override {
    cleave_release(sample_);
    cleave_publisher_close(publisher_);
    cleave_reader_close(reader_);
  }
  // x, y, z of the cloud that comes next.
  const float* received() {
    cleave_release(std::exchange(sample_, nullptr));
    const float* xyz = nullptr;
    std::size_t count = 0;
    EXPECT_EQ(cleave_wait(reader_, 10'000), CLEAVE_OK);
    EXPECT_EQ(cleave_take(reader_, &sample_), CLEAVE_OK);
    EXPECT_EQ(cleave_sample_cloud(sample_, &xyz, &count), CLEAVE_OK) << cleave_error();
    EXPECT_EQ(count, 8U);
    return xyz;
  }

  cleave_reader* reader_;
  cleave_publisher* publisher_;
  cleave_sample* sample_ = nullptr;
};

TEST_F(PublisherOfC, TurnsDepthOfEitherTypeIntoPoints) {
  const std::array<std::uint16_t, 8> depth_mm = {1000, 1000, 1000, 1000, 0, 2000, 2000, 2000};
  ASSERT_EQ(cleave_publish_depth16(publisher_, depth_mm.data(), 8, .001F, 0), CLEAVE_OK);
  const float* xyz = received();
  EXPECT_FLOAT_EQ(xyz[0], -.5F);
  EXPECT_FLOAT_EQ(xyz[2], 1);
  EXPECT_TRUE(std::isnan(xyz[12]));
  EXPECT_GT(cleave_sample_header(sample_)->capture_time_ns, 1'000'000'000'000'000'000);

  const std::array<float, 8> depth_m = {1, 1, 1, 1, 0, 2, NAN, 2};
  ASSERT_EQ(cleave_publish_depth32(publisher_, depth_m.data(), 8, 0), CLEAVE_OK);
  xyz = received();
  EXPECT_FLOAT_EQ(xyz[0], -.5F);
  EXPECT_TRUE(std::isnan(xyz[18]));
  EXPECT_FLOAT_EQ(xyz[23], 2);
}

TEST_F(PublisherOfC, LendsTheMemoryThatIsPublished) {
  float* room = nullptr;
  std::size_t count = 0;
  ASSERT_EQ(cleave_loan(publisher_, &room, &count), CLEAVE_OK);
  ASSERT_EQ(count, 8U);
  std::copy(points_.begin(), points_.end(), room);
  ASSERT_EQ(cleave_publish_loan(publisher_, 5), CLEAVE_OK);
  EXPECT_EQ(received()[23], 24.0F);
  EXPECT_EQ(cleave_sample_header(sample_)->capture_time_ns, 5);
}

TEST_F(PublisherOfC, TakesALoanBackThatIsNotPublished) {
  float* first = nullptr;
  float* second = nullptr;
  std::size_t count = 0;
  ASSERT_EQ(cleave_loan(publisher_, &first, &count), CLEAVE_OK);
  for (int i = 0; i < 20; ++i) {  // DDS lends 8 at a time
    ASSERT_EQ(cleave_loan(publisher_, &second, &count), CLEAVE_OK);
    EXPECT_EQ(second, first);
  }
  ASSERT_EQ(cleave_publish_loan(publisher_, 0), CLEAVE_OK);
  EXPECT_EQ(cleave_publish_loan(publisher_, 0), CLEAVE_BAD_ARGUMENT);
  EXPECT_STREQ(cleave_error(), "nothing is on loan: call cleave_loan() first");
  ASSERT_EQ(cleave_loan(publisher_, &first, &count), CLEAVE_OK);  // closed with a loan out
}

TEST_F(PublisherOfC, LendsRoomForTheLargestCamera) {
  cleave_publisher_close(publisher_);
  cleave_camera settings = camera();
  settings.width = 1600;
  settings.height = 1200;
  ASSERT_EQ(cleave_publisher_open(stream_, &settings, &publisher_), CLEAVE_OK) << cleave_error();
  ASSERT_TRUE(test::eventually([&] { return cleave_publisher_readers(publisher_) == 1; }));
  float* room = nullptr;
  std::size_t count = 0;
  ASSERT_EQ(cleave_loan(publisher_, &room, &count), CLEAVE_OK);
  ASSERT_EQ(count, 1600U * 1200U);
  room[3 * count - 1] = 5;
  ASSERT_EQ(cleave_publish_loan(publisher_, 0), CLEAVE_OK);
  ASSERT_EQ(cleave_wait(reader_, 10'000), CLEAVE_OK);
  ASSERT_EQ(cleave_take(reader_, &sample_), CLEAVE_OK);
  const float* xyz = nullptr;
  ASSERT_EQ(cleave_sample_cloud(sample_, &xyz, &count), CLEAVE_OK);
  ASSERT_EQ(count, 1600U * 1200U);
  EXPECT_EQ(xyz[3 * count - 1], 5.0F);
}

TEST_F(PublisherOfC, RefusesAFrameOfAnotherSize) {
  for (const std::size_t count : {std::size_t{0}, std::size_t{7}, std::size_t{9}, SIZE_MAX}) {
    const std::array<std::uint16_t, 8> depth{};
    EXPECT_EQ(cleave_publish_points(publisher_, points_.data(), count, 0), CLEAVE_BAD_ARGUMENT);
    EXPECT_EQ(cleave_publish_depth32(publisher_, points_.data(), count, 0), CLEAVE_BAD_ARGUMENT);
    EXPECT_EQ(cleave_publish_depth16(publisher_, depth.data(), count, 1, 0), CLEAVE_BAD_ARGUMENT);
  }
  EXPECT_EQ(cleave_publish_depth32(publisher_, points_.data(), 7, 0), CLEAVE_BAD_ARGUMENT);
  EXPECT_STREQ(cleave_error(), "a frame of 4 x 2 points has 8 values, not 7");
}

TEST_F(PublisherOfC, RefusesAUnitThatIsNone) {
  const std::array<std::uint16_t, 8> depth{};
  for (const float unit_m : {0.0F, -.001F, NAN, std::numeric_limits<float>::infinity()}) {
    EXPECT_EQ(cleave_publish_depth16(publisher_, depth.data(), 8, unit_m, 0), CLEAVE_BAD_ARGUMENT);
  }
}

TEST_F(PublisherOfC, IsItsSensorsOnlyOne) {
  const cleave_camera settings = camera();
  cleave_publisher* second = nullptr;
  EXPECT_EQ(cleave_publisher_open(stream_, &settings, &second), CLEAVE_FAILED);
  EXPECT_NE(std::string(cleave_error()).find("is already published by process"), std::string::npos);
}

TEST_F(PublisherOfC, RefusesACameraThatCannotBe) {
  cleave_publisher* other = nullptr;
  const auto refused = [&](const cleave_camera& settings) {
    const cleave_result result = cleave_publisher_open(stream_, &settings, &other);
    return result == CLEAVE_BAD_ARGUMENT && other == nullptr;
  };
  cleave_camera settings = camera();
  settings.sensor = "a b";
  EXPECT_TRUE(refused(settings));
  settings = camera();
  settings.width = settings.height = 0xFFFFFFFFU;
  EXPECT_TRUE(refused(settings));
  settings = camera();
  settings.fx = -1;
  EXPECT_TRUE(refused(settings));
  settings = camera();
  settings.parent_frame = "base_link";  // without an orientation
  EXPECT_TRUE(refused(settings));
}

TEST_F(PublisherOfC, TellsThePoseOnlyWithItsFrame) {
  cleave_publisher_close(publisher_);
  cleave_camera settings = camera();
  settings.pose.position.x = 7;
  settings.pose.orientation.w = 1;
  ASSERT_EQ(cleave_publisher_open(stream_, &settings, &publisher_), CLEAVE_OK) << cleave_error();
  cleave_publisher_close(publisher_);
  settings.parent_frame = "base_link";
  ASSERT_EQ(cleave_publisher_open(stream_, &settings, &publisher_), CLEAVE_OK) << cleave_error();
  ASSERT_TRUE(test::eventually([&] { return cleave_publisher_readers(publisher_) == 1; }));
  ASSERT_EQ(cleave_publish_points(publisher_, points_.data(), 8, 0), CLEAVE_OK);
  (void)received();
  EXPECT_STREQ(cleave_sample_header(sample_)->parent_frame, "base_link");
  EXPECT_EQ(cleave_sample_header(sample_)->pose.position.x, 7.0F);
  EXPECT_EQ(cleave_sample_header(sample_)->pose.orientation.w, 1.0F);
}

}  // namespace
}  // namespace cleave
