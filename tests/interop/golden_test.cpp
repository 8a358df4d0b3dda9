// SPDX-License-Identifier: BSD-3-Clause
// The golden files through Fast CDR, with the types that fastddsgen makes of the contract.
#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>
#include <gtest/gtest.h>

#include <memory>

#include "cleave_v1.h"
#include "tests/unit/golden/golden_files.hpp"

namespace cleave::test {
namespace {

using eprosima::fastcdr::Cdr;
using eprosima::fastcdr::FastBuffer;
using CdrBytes = std::vector<std::byte>;

template <class T>
std::unique_ptr<T> deserialised(CdrBytes bytes) {
  FastBuffer buffer(reinterpret_cast<char*>(bytes.data()), bytes.size());
  Cdr cdr(buffer, Cdr::DEFAULT_ENDIAN, Cdr::DDS_CDR);
  cdr.read_encapsulation();
  auto sample = std::make_unique<T>();
  sample->deserialize(cdr);
  return sample;
}

template <class T>
CdrBytes serialised(const T& sample, Cdr::Endianness byte_order, std::size_t size) {
  CdrBytes bytes(size);
  FastBuffer buffer(reinterpret_cast<char*>(bytes.data()), bytes.size());
  Cdr cdr(buffer, byte_order, Cdr::DDS_CDR);
  cdr.serialize_encapsulation();
  sample.serialize(cdr);
  EXPECT_EQ(cdr.getSerializedDataLength(), size);
  return bytes;
}

// What was read of one byte order and is written in the other had every field at its place.
template <class T>
void expect_golden(const std::string& type) {
  for (const GoldenSample& golden : golden_samples(type)) {
    for (const CdrBytes& bytes : {golden.little_endian, golden.big_endian}) {
      const auto sample = deserialised<T>(bytes);
      EXPECT_TRUE(serialised(*sample, Cdr::LITTLE_ENDIANNESS, bytes.size()) == golden.little_endian)
          << golden.name;
      EXPECT_TRUE(serialised(*sample, Cdr::BIG_ENDIANNESS, bytes.size()) == golden.big_endian)
          << golden.name;
    }
  }
}

TEST(FastCdrGoldenFiles, OfCloudsComeBackAsTheyWere) {
  expect_golden<v1::DepthCloud>("DepthCloud");
  expect_golden<v1::LargeDepthCloud>("LargeDepthCloud");
}

TEST(FastCdrGoldenFiles, OfLabelMapsComeBackAsTheyWere) {
  expect_golden<v1::LabelMap>("LabelMap");
  expect_golden<v1::LargeLabelMap>("LargeLabelMap");
}

TEST(FastCdrGoldenFiles, OfSegmentListsAndStatusesComeBackAsTheyWere) {
  expect_golden<v1::SegmentList>("SegmentList");
  expect_golden<v1::NodeStatus>("NodeStatus");
}

TEST(FastCdrGoldenFiles, SayWhatTheirJsonSays) {
  for (const GoldenSample& golden : golden_samples("SegmentList")) {
    const auto list = deserialised<v1::SegmentList>(golden.big_endian);
    EXPECT_EQ(std::to_string(list->header().frame_id()), golden.json["header"]["frame_id"]);
    EXPECT_EQ(std::string(list->header().parent_frame().data()),
              golden.json["header"]["parent_frame"]);
    ASSERT_EQ(list->segments().size(), golden.json["segments"].size());
    for (std::size_t i = 0; i < list->segments().size(); ++i) {
      EXPECT_EQ(list->segments()[i].point_count(), golden.json["segments"][i]["point_count"]);
    }
  }
  for (const GoldenSample& golden : golden_samples("NodeStatus")) {
    const auto status = deserialised<v1::NodeStatus>(golden.big_endian);
    EXPECT_EQ(status->last_error(), golden.json["last_error"]);
    EXPECT_EQ(std::to_string(status->frames_zero_copy()), golden.json["frames_zero_copy"]);
    EXPECT_EQ(status->cpu_time_s(), golden.json["cpu_time_s"]);
  }
}

}  // namespace
}  // namespace cleave::test
