// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstring>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "libcleave/cloud_writer.hpp"
#include "libcleave/sequence.hpp"
#include "libcleave/writer.hpp"
#include "tests/unit/c/c_stream.hpp"

namespace cleave {
namespace {

class ReaderOfC : public test::CStream {
 protected:
  ~ReaderOfC() override {
    cleave_release(sample_);
    cleave_reader_close(reader_);
  }
  void publish_a_cloud() {
    ASSERT_EQ(cleave_publish_points(publisher_, points_.data(), 8, 77), CLEAVE_OK);
  }
  void open_clouds() {
    reader_ = reader(CLEAVE_CLOUD);
    publisher_ = publisher();
    publish_a_cloud();
  }
  void take_when_it_comes() {
    ASSERT_EQ(cleave_wait(reader_, 10'000), CLEAVE_OK) << cleave_error();
    ASSERT_EQ(cleave_take(reader_, &sample_), CLEAVE_OK) << cleave_error();
  }
  void close_publisher() { cleave_publisher_close(std::exchange(publisher_, nullptr)); }

  cleave_reader* reader_ = nullptr;
  cleave_publisher* publisher_ = nullptr;
  cleave_sample* sample_ = nullptr;
};

TEST_F(ReaderOfC, HandsOutPointsAndHeader) {
  open_clouds();
  take_when_it_comes();
  EXPECT_EQ(cleave_sample_kind(sample_), CLEAVE_CLOUD);
  EXPECT_EQ(cleave_sample_zero_copy(sample_), 0);
  const float* xyz = nullptr;
  std::size_t count = 0;
  ASSERT_EQ(cleave_sample_cloud(sample_, &xyz, &count), CLEAVE_OK);
  ASSERT_EQ(count, 8U);
  EXPECT_TRUE(std::equal(points_.begin(), points_.end(), xyz));
  const cleave_header* const header = cleave_sample_header(sample_);
  ASSERT_NE(header, nullptr);
  EXPECT_EQ(header->width, 4U);
  EXPECT_EQ(header->height, 2U);
  EXPECT_EQ(header->capture_time_ns, 77);
  EXPECT_EQ(header->sensor, sensor_);
  EXPECT_EQ(header->coordinate_frame, sensor_ + "_optical");
  EXPECT_EQ(cleave_reader_writers(reader_), 1U);
  close_publisher();
}

TEST_F(ReaderOfC, SaysThatASampleIsOfAnotherKind) {
  open_clouds();
  take_when_it_comes();
  const std::uint16_t* labels = nullptr;
  std::size_t count = 99;
  cleave_list list{};
  cleave_status status{};
  EXPECT_EQ(cleave_sample_labels(sample_, &labels, &count, nullptr), CLEAVE_BAD_DATA);
  EXPECT_STREQ(cleave_error(), "the sample is no label map");
  EXPECT_EQ(cleave_sample_list(sample_, &list), CLEAVE_BAD_DATA);
  EXPECT_EQ(cleave_sample_status(sample_, &status), CLEAVE_BAD_DATA);
  EXPECT_EQ(count, 99U) << "a failure writes nothing";
  EXPECT_EQ(cleave_sample_cloud(sample_, nullptr, &count), CLEAVE_BAD_ARGUMENT);
  close_publisher();
}

TEST_F(ReaderOfC, OfASensorThatIsNotThereWaitsAndSaysSo) {
  reader_ = reader(CLEAVE_SEGMENTS);
  EXPECT_EQ(cleave_take(reader_, &sample_), CLEAVE_TIMEOUT);
  EXPECT_EQ(cleave_wait(reader_, 1), CLEAVE_TIMEOUT);
  EXPECT_STREQ(cleave_error(), "no sample came in time: nobody publishes them");
  EXPECT_EQ(cleave_reader_writers(reader_), 0U);
}

TEST_F(ReaderOfC, HasADescriptorThatIsReadableWhileSamplesWait) {
  open_clouds();
  const int descriptor = cleave_reader_fd(reader_);
  for (int round = 0; round < 3; ++round) {
    ASSERT_TRUE(test::eventually([&] { return test::is_readable(descriptor); }));
    ASSERT_TRUE(test::eventually([&] { return cleave_take(reader_, &sample_) == CLEAVE_OK; }));
    EXPECT_EQ(cleave_take(reader_, &sample_), CLEAVE_TIMEOUT);
    EXPECT_FALSE(test::is_readable(descriptor));
    cleave_release(std::exchange(sample_, nullptr));
    publish_a_cloud();
  }
  close_publisher();
}

TEST_F(ReaderOfC, KeepsItsDescriptorReadableForWhatAWaitHasFound) {
  open_clouds();
  ASSERT_EQ(cleave_wait(reader_, 10'000), CLEAVE_OK);
  ASSERT_EQ(cleave_wait(reader_, 0), CLEAVE_OK) << "a wait takes nothing";
  EXPECT_TRUE(test::is_readable(cleave_reader_fd(reader_)));
  EXPECT_EQ(cleave_take(reader_, &sample_), CLEAVE_OK);
  EXPECT_EQ(cleave_wait(reader_, 0), CLEAVE_TIMEOUT);
  close_publisher();
}

TEST_F(ReaderOfC, WaitsAndTakesInOneCall) {
  open_clouds();
  ASSERT_EQ(cleave_next(reader_, 10'000, &sample_), CLEAVE_OK) << cleave_error();
  EXPECT_EQ(cleave_sample_header(sample_)->capture_time_ns, 77);
  cleave_sample* none = nullptr;
  EXPECT_EQ(cleave_next(reader_, 1, &none), CLEAVE_TIMEOUT);
  EXPECT_STREQ(cleave_error(), "no sample came in time");
  EXPECT_EQ(none, nullptr);
  close_publisher();
}

TEST_F(ReaderOfC, AndItsSamplesLiveOnBehindHandlesThatAreClosed) {
  open_clouds();
  take_when_it_comes();
  cleave_close(std::exchange(stream_, nullptr));
  cleave_reader_close(std::exchange(reader_, nullptr));
  close_publisher();
  const float* xyz = nullptr;
  std::size_t count = 0;
  ASSERT_EQ(cleave_sample_cloud(sample_, &xyz, &count), CLEAVE_OK);
  EXPECT_EQ(xyz[23], 24.0F);
  EXPECT_TRUE(is_open());
  std::thread([&] { cleave_release(std::exchange(sample_, nullptr)); }).join();
  EXPECT_FALSE(is_open());
}

TEST_F(ReaderOfC, RefusesWhatCannotBeRead) {
  const auto refused = [&](unsigned kind, const char* sensor, std::uint32_t depth) {
    return cleave_reader_open(stream_, static_cast<cleave_kind>(kind), sensor, depth, &reader_);
  };
  EXPECT_EQ(refused(CLEAVE_CLOUD, "a/b", 0), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(refused(CLEAVE_CLOUD, "", 0), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(refused(CLEAVE_CLOUD, std::string(64, 'a').c_str(), 0), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(refused(CLEAVE_LABELS, "a", 257), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(reader_, nullptr);
  EXPECT_EQ(refused(CLEAVE_STATUS, nullptr, 8), CLEAVE_OK) << "a status is of no sensor";
}

TEST_F(ReaderOfC, HandsOutLabelsWithTheTimeOfTheirCloud) {
  reader_ = reader(CLEAVE_LABELS);
  LabelWriter writer(cpp_stream(), sensor_);
  ASSERT_TRUE(test::eventually([&] { return writer.matched_readers() == 1; }));
  auto loan = writer.loan(6);
  ASSERT_TRUE(loan);
  loan->header() = FrameHeader{};
  loan->header().width = 3;
  loan->header().height = 2;
  loan->cloud_publication_time_ns() = 55;
  for (std::uint16_t i = 0; i < 6; ++i) loan->room()[i] = i;
  ASSERT_TRUE(std::move(*loan).publish());
  take_when_it_comes();
  const std::uint16_t* labels = nullptr;
  std::size_t count = 0;
  std::int64_t time = 0;
  ASSERT_EQ(cleave_sample_labels(sample_, &labels, &count, &time), CLEAVE_OK);
  EXPECT_EQ(std::vector<std::uint16_t>(labels, labels + count),
            (std::vector<std::uint16_t>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(time, 55);
  EXPECT_EQ(cleave_sample_labels(sample_, &labels, &count, nullptr), CLEAVE_OK);
}

TEST_F(ReaderOfC, HandsOutNoPointsWhereAHeaderLies) {
  reader_ = reader(CLEAVE_CLOUD);
  CloudWriter writer(cpp_stream(), sensor_);
  ASSERT_TRUE(test::eventually([&] { return writer.matched_readers() == 1; }));
  auto loan = writer.loan(1);
  ASSERT_TRUE(loan);
  loan->header() = FrameHeader{};
  loan->header().width = loan->header().height = 0xFFFFFFFFU;
  ASSERT_TRUE(std::move(*loan).publish());
  take_when_it_comes();
  const float* xyz = nullptr;
  std::size_t count = 0;
  EXPECT_EQ(cleave_sample_cloud(sample_, &xyz, &count), CLEAVE_BAD_DATA);
  EXPECT_STREQ(cleave_error(),
               "the header announces 4294967295 x 4294967295 points, more than the sample has room "
               "for");
  EXPECT_EQ(xyz, nullptr);
}

TEST_F(ReaderOfC, DropsASampleWithANameThatDoesNotEnd) {
  reader_ = reader(CLEAVE_SEGMENTS);
  Writer<SegmentList> writer(cpp_stream(), sensor_);
  ASSERT_TRUE(test::eventually([&] { return writer.matched_readers() == 1; }));
  SegmentList list{};
  std::memset(list.header.parent_frame, 'x', sizeof list.header.parent_frame);
  ASSERT_TRUE(writer.publish(list));
  ASSERT_EQ(cleave_wait(reader_, 10'000), CLEAVE_OK);
  EXPECT_EQ(cleave_take(reader_, &sample_), CLEAVE_BAD_DATA);
  EXPECT_EQ(cleave_take(reader_, &sample_), CLEAVE_TIMEOUT);
}

TEST_F(ReaderOfC, HandsOutAListWhereItIs) {
  reader_ = reader(CLEAVE_SEGMENTS);
  Writer<SegmentList> writer(cpp_stream(), sensor_);
  ASSERT_TRUE(test::eventually([&] { return writer.matched_readers() == 1; }));
  std::vector<SegmentMessage> segments(2);
  segments[1].label = 2;
  segments[1].point_count = 500;
  segments[1].box.extent = {3, 2, 1};
  segments[1].planarity = .5F;
  std::vector<BorderMessage> borders = {{1, 2, cleave_v1_BORDER_CONVEX}};
  SegmentList list{};
  list.header.frame_id = 9;
  list.cloud_reception_time_ns = 66;
  list.queue_ms = 1.5F;
  list.segmentation_ms = 2.5F;
  lend(list.segments, segments);
  lend(list.borders, borders);
  ASSERT_TRUE(writer.publish(list));
  take_when_it_comes();
  cleave_list out{};
  ASSERT_EQ(cleave_sample_list(sample_, &out), CLEAVE_OK);
  EXPECT_EQ(out.header, cleave_sample_header(sample_));
  EXPECT_EQ(out.header->frame_id, 9U);
  EXPECT_EQ(out.cloud_reception_time_ns, 66);
  ASSERT_EQ(out.segment_count, 2U);
  EXPECT_EQ(out.segments[1].label, 2U);
  EXPECT_EQ(out.segments[1].point_count, 500U);
  EXPECT_EQ(out.segments[1].box.extent.y, 2.0F);
  EXPECT_EQ(out.segments[1].planarity, .5F);
  ASSERT_EQ(out.border_count, 1U);
  EXPECT_EQ(out.borders[0].second, 2U);
  EXPECT_EQ(out.borders[0].kind, 1U);
  EXPECT_EQ(out.queue_ms, 1.5F);
  EXPECT_EQ(out.segmentation_ms, 2.5F);
}

TEST_F(ReaderOfC, HandsOutTheStatusThatAPublisherTells) {
  reader_ = reader(CLEAVE_STATUS);
  const cleave_camera settings = camera();
  ASSERT_EQ(cleave_publisher_open(stream_, &settings, &publisher_), CLEAVE_OK);
  take_when_it_comes();
  EXPECT_EQ(cleave_sample_header(sample_), nullptr);
  cleave_status status{};
  ASSERT_EQ(cleave_sample_status(sample_, &status), CLEAVE_OK);
  EXPECT_EQ(status.node, "grabber/" + sensor_);
  EXPECT_EQ(status.sensor, sensor_);
  EXPECT_STREQ(status.contract, "cleave_v1");
  EXPECT_EQ(status.process_id, static_cast<std::uint32_t>(::getpid()));
  EXPECT_STREQ(cleave_state_name(status.state), "running");
  EXPECT_EQ(status.transport, 1U);
  EXPECT_EQ(status.dropped_cause_count, 0U);
  EXPECT_STREQ(status.last_error, "");
  close_publisher();
}

}  // namespace
}  // namespace cleave
