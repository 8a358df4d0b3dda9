// SPDX-License-Identifier: BSD-3-Clause
// Bytes in, bytes out. tests/unit/libcleave/cdr_test.cpp damages them.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <memory>
#include <vector>

#include "c/cleave.h"
#include "libcleave/cdr.hpp"

namespace cleave {
namespace {

struct Release {
  void operator()(cleave_sample* sample) const { cleave_release(sample); }
};
using Held = std::unique_ptr<cleave_sample, Release>;

Held decoded(cleave_kind kind, int large, const std::vector<std::byte>& bytes) {
  cleave_sample* sample = nullptr;
  EXPECT_EQ(cleave_decode(kind, large, bytes.data(), bytes.size(), &sample), CLEAVE_OK)
      << cleave_error();
  return Held(sample);
}

std::vector<std::byte> encoded(const Held& sample) {
  const void* bytes = nullptr;
  std::size_t size = 0;
  EXPECT_EQ(cleave_encode(sample.get(), &bytes, &size), CLEAVE_OK) << cleave_error();
  const auto* const first = static_cast<const std::byte*>(bytes);
  return {first, first + size};
}

template <class T>
std::vector<std::byte> bulk_bytes(std::uint32_t width, std::uint32_t height) {
  const auto sample = std::make_unique<T>();
  sample->header.width = width;
  sample->header.height = height;
  return cdr_of(*sample);
}

TEST(CdrOfC, OfEveryKindComesBackAsItWas) {
  const auto cloud = bulk_bytes<DepthCloud>(640, 480);
  EXPECT_EQ(encoded(decoded(CLEAVE_CLOUD, 0, cloud)), cloud);
  const auto large_cloud = bulk_bytes<LargeDepthCloud>(1600, 1200);
  EXPECT_EQ(encoded(decoded(CLEAVE_CLOUD, 1, large_cloud)), large_cloud);
  const auto labels = bulk_bytes<LabelMap>(640, 480);
  EXPECT_EQ(encoded(decoded(CLEAVE_LABELS, 0, labels)), labels);
  const auto large_labels = bulk_bytes<LargeLabelMap>(1600, 1200);
  EXPECT_EQ(encoded(decoded(CLEAVE_LABELS, 1, large_labels)), large_labels);
  const auto list = cdr_of(SegmentList{});
  EXPECT_EQ(encoded(decoded(CLEAVE_SEGMENTS, 0, list)), list);
}

TEST(CdrOfC, OfALargeCloudHasAllItsPoints) {
  const Held sample = decoded(CLEAVE_CLOUD, 1, bulk_bytes<LargeDepthCloud>(1600, 1200));
  const float* xyz = nullptr;
  std::size_t count = 0;
  ASSERT_EQ(cleave_sample_cloud(sample.get(), &xyz, &count), CLEAVE_OK);
  EXPECT_EQ(count, 1600U * 1200U);
  EXPECT_EQ(xyz[3 * count - 1], 0.0F);
}

TEST(CdrOfC, OfASmallCloudIsNoLargeOneNorALabelMap) {
  const auto bytes = bulk_bytes<DepthCloud>(640, 480);
  cleave_sample* sample = nullptr;
  EXPECT_EQ(cleave_decode(CLEAVE_CLOUD, 1, bytes.data(), bytes.size(), &sample), CLEAVE_BAD_DATA);
  EXPECT_EQ(cleave_decode(CLEAVE_LABELS, 0, bytes.data(), bytes.size(), &sample), CLEAVE_BAD_DATA);
  EXPECT_NE(std::strstr(cleave_error(), "LabelMap"), nullptr) << cleave_error();
  EXPECT_EQ(sample, nullptr);
}

TEST(CdrOfC, WithANameThatDoesNotEndIsRefused) {
  SegmentList list{};
  std::memset(list.header.sensor, 'x', sizeof list.header.sensor);
  const auto bytes = cdr_of(list);
  cleave_sample* sample = nullptr;
  EXPECT_EQ(cleave_decode(CLEAVE_SEGMENTS, 0, bytes.data(), bytes.size(), &sample),
            CLEAVE_BAD_DATA);
}

}  // namespace
}  // namespace cleave
