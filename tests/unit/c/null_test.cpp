// SPDX-License-Identifier: BSD-3-Clause
// Every function with every pointer null.
#include "tests/unit/c/c_stream.hpp"

namespace cleave {
namespace {

using OfNull = test::CStream;

TEST_F(OfNull, HandlesAreRefusedNotFollowed) {
  cleave_reader* reader = nullptr;
  cleave_frames* frames = nullptr;
  cleave_publisher* publisher = nullptr;
  cleave_sample* sample = nullptr;
  const cleave_camera settings = camera();
  const float* xyz = nullptr;
  float* room = nullptr;
  const std::uint16_t* labels = nullptr;
  const void* bytes = nullptr;
  std::size_t count = 0;
  cleave_list list{};
  cleave_status status{};
  const std::array<std::uint16_t, 8> depth{};
  EXPECT_EQ(cleave_reader_open(nullptr, CLEAVE_CLOUD, "a", 0, &reader), CLEAVE_BAD_ARGUMENT);
  EXPECT_STREQ(cleave_error(), "stream is a null pointer");
  EXPECT_EQ(cleave_take(nullptr, &sample), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_wait(nullptr, 0), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_next(nullptr, 0, nullptr), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_frames_open(nullptr, "a", &frames), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_frames_next(nullptr, 0, &sample, &sample, &sample), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_sample_cloud(nullptr, &xyz, &count), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_sample_labels(nullptr, &labels, &count, nullptr), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_sample_list(nullptr, &list), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_sample_status(nullptr, &status), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_encode(nullptr, &bytes, &count), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_publisher_open(nullptr, &settings, &publisher), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_publish_depth16(nullptr, depth.data(), 8, 1, 0), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_publish_depth32(nullptr, points_.data(), 8, 0), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_publish_points(nullptr, points_.data(), 8, 0), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_loan(nullptr, &room, &count), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_publish_loan(nullptr, 0), CLEAVE_BAD_ARGUMENT);
}

TEST_F(OfNull, HandlesOfFunctionsWithoutAResultAreNothing) {
  cleave_close(nullptr);
  cleave_reader_close(nullptr);
  cleave_frames_close(nullptr);
  cleave_publisher_close(nullptr);
  cleave_release(nullptr);
  const char* reason = "untouched";
  EXPECT_EQ(cleave_uses_shared_memory(nullptr, &reason), 0);
  EXPECT_EQ(cleave_reader_fd(nullptr), -1);
  EXPECT_EQ(cleave_reader_writers(nullptr), 0U);
  EXPECT_EQ(cleave_frames_fd(nullptr), -1);
  EXPECT_EQ(cleave_frames_given_up(nullptr), 0U);
  EXPECT_EQ(cleave_sample_kind(nullptr), CLEAVE_CLOUD);
  EXPECT_EQ(cleave_sample_zero_copy(nullptr), 0);
  EXPECT_EQ(cleave_sample_header(nullptr), nullptr);
  EXPECT_EQ(cleave_publisher_readers(nullptr), 0U);
  EXPECT_STREQ(reason, "untouched");
}

TEST_F(OfNull, PlacesForResultsAndInputsAreRefused) {
  cleave_reader* const clouds = reader(CLEAVE_CLOUD);
  cleave_publisher* const own = publisher();
  cleave_frames* frames = nullptr;
  cleave_reader* none = nullptr;
  cleave_sample* sample = nullptr;
  float* room = nullptr;
  std::size_t count = 0;
  EXPECT_EQ(cleave_open(nullptr, nullptr), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_reader_open(stream_, CLEAVE_CLOUD, nullptr, 0, &none), CLEAVE_BAD_ARGUMENT);
  EXPECT_STREQ(cleave_error(), "sensor is a null pointer");
  EXPECT_EQ(cleave_reader_open(stream_, CLEAVE_CLOUD, "a", 0, nullptr), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_take(clouds, nullptr), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_frames_open(stream_, nullptr, &frames), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_frames_open(stream_, "a", nullptr), CLEAVE_BAD_ARGUMENT);
  ASSERT_EQ(cleave_frames_open(stream_, "a", &frames), CLEAVE_OK);
  EXPECT_EQ(cleave_frames_next(frames, 0, nullptr, &sample, &sample), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_frames_next(frames, 0, &sample, nullptr, &sample), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_frames_next(frames, 0, &sample, &sample, nullptr), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_decode(CLEAVE_STATUS, 0, nullptr, 8, &sample), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_decode(CLEAVE_STATUS, 0, "12345678", 8, nullptr), CLEAVE_BAD_ARGUMENT);
  const cleave_camera settings = camera();
  cleave_camera nameless = settings;
  nameless.sensor = nullptr;
  cleave_publisher* second = nullptr;
  EXPECT_EQ(cleave_publisher_open(stream_, nullptr, &second), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_publisher_open(stream_, &settings, nullptr), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_publisher_open(stream_, &nameless, &second), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_publish_depth16(own, nullptr, 8, 1, 0), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_publish_depth32(own, nullptr, 8, 0), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_publish_points(own, nullptr, 8, 0), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_loan(own, nullptr, &count), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(cleave_loan(own, &room, nullptr), CLEAVE_BAD_ARGUMENT);
  cleave_publisher_close(own);
  cleave_frames_close(frames);
  cleave_reader_close(clouds);
}

}  // namespace
}  // namespace cleave
