// SPDX-License-Identifier: BSD-3-Clause
// The segment lists of recordings are what DDS puts on the wire: Fast CDR reads them by the
// contract.
#include <gtest/gtest.h>

#include <cstring>

#include "cleave_v1PubSubTypes.h"
#include "recording/frames/segment_list_message.hpp"
#include "tests/unit/recording/recording_files.hpp"

namespace cleave::test {
namespace {

TEST(FastCdr, ReadsASegmentListOfARecording) {
  const recording::SegmentList list = recording::segment_list(42);
  const recording::Bytes message = recording::segment_list_message(list);
  eprosima::fastrtps::rtps::SerializedPayload_t payload(static_cast<std::uint32_t>(message.size()));
  std::memcpy(payload.data, message.data(), message.size());
  payload.length = static_cast<std::uint32_t>(message.size());

  cleave::v1::SegmentList read;
  cleave::v1::SegmentListPubSubType type;
  ASSERT_TRUE(type.deserialize(&payload, &read));
  EXPECT_EQ(read.header().frame_id(), list.header.frame_id);
  EXPECT_EQ(read.header().device_time_us(), list.header.device_time_us);
  EXPECT_STREQ(read.header().coordinate_frame().data(), list.header.coordinate_frame.c_str());
  EXPECT_EQ(read.cloud_publication_time_ns(), list.cloud_publication_time_ns);
  EXPECT_EQ(read.header().arrival_time_ns(), list.header.arrival_time_ns);
  EXPECT_EQ(read.cloud_reception_time_ns(), list.cloud_reception_time_ns);
  ASSERT_EQ(read.segments().size(), list.segments.size());
  for (std::size_t i = 0; i < list.segments.size(); ++i) {
    EXPECT_EQ(read.segments()[i].label(), list.segments[i].label);
    EXPECT_EQ(read.segments()[i].point_count(), list.segments[i].point_count);
    EXPECT_EQ(read.segments()[i].box().extent().z(), list.segments[i].box.extent.z);
    EXPECT_EQ(read.segments()[i].rectangle().bottom(), list.segments[i].rectangle.bottom);
    EXPECT_EQ(read.segments()[i].planarity(), list.segments[i].planarity);
  }
  ASSERT_EQ(read.borders().size(), list.borders.size());
  EXPECT_EQ(read.borders()[1].kind(), cleave::v1::BORDER_CONVEX);
  EXPECT_EQ(read.segmentation_ms(), list.segmentation_ms);
}

}  // namespace
}  // namespace cleave::test
