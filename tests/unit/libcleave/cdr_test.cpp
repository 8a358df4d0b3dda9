// SPDX-License-Identifier: BSD-3-Clause
// Samples from and to bytes, and from bytes that are damaged.
#include "libcleave/cdr.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "libcleave/reader.hpp"
#include "libcleave/sequence.hpp"

namespace cleave {
namespace {

using CdrBytes = std::vector<std::byte>;

CdrBytes list_bytes() {
  std::vector<SegmentMessage> segments(3);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    segments[i].label = static_cast<std::uint16_t>(i + 1);
    segments[i].planarity = .25F;
  }
  std::vector<BorderMessage> borders = {{1, 2, cleave_v1_BORDER_CONVEX},
                                        {2, 3, cleave_v1_BORDER_CONCAVE}};
  SegmentList list{};
  list.header.frame_id = 0x0102030405060708;
  EXPECT_TRUE(set_name(list.header.sensor, "camera"));
  lend(list.segments, segments);
  lend(list.borders, borders);
  list.segmentation_ms = 20.5F;
  return cdr_of(list);
}

CdrBytes status_bytes() {
  std::array<std::string, 9> texts = {"grabber/camera", "0.1.0",         "cleave_v1",
                                      "camera",         "RouDi answers", "no free chunk",
                                      "other",          "bad header",    ""};
  std::vector<cleave_v1_CauseCount> dropped = {{texts[5].data(), 3}, {texts[6].data(), 4}};
  std::vector<cleave_v1_CauseCount> rejected = {{texts[7].data(), 5}};
  NodeStatus status{};
  status.node = texts[0].data();
  status.version = texts[1].data();
  status.contract = texts[2].data();
  status.sensor = texts[3].data();
  status.transport_reason = texts[4].data();
  status.last_error = texts[8].data();
  status.state = cleave_v1_STATE_ENDED;
  lend(status.dropped_by_cause, dropped);
  lend(status.rejected_by_cause, rejected);
  return cdr_of(status);
}

template <class T>
CdrBytes bulk_bytes() {
  const auto sample = std::make_unique<T>();
  sample->header.width = 640;
  sample->header.height = 480;
  return cdr_of(*sample);
}

TEST(Cdr, OfAListComesBackAsItWas) {
  const CdrBytes bytes = list_bytes();
  const Sample<SegmentList> list(sample_of_cdr<SegmentList>(bytes));
  EXPECT_EQ(list->header.frame_id, 0x0102030405060708U);
  ASSERT_EQ(elements_of(list->segments).size(), 3U);
  EXPECT_EQ(elements_of(list->segments)[2].label, 3U);
  ASSERT_EQ(elements_of(list->borders).size(), 2U);
  EXPECT_EQ(elements_of(list->borders)[0].kind, cleave_v1_BORDER_CONVEX);
  EXPECT_EQ(list->segmentation_ms, 20.5F);
  EXPECT_EQ(cdr_of(*list), bytes);
}

TEST(Cdr, OfAStatusComesBackAsItWas) {
  const CdrBytes bytes = status_bytes();
  const Sample<NodeStatus> status(sample_of_cdr<NodeStatus>(bytes));
  EXPECT_STREQ(status->node, "grabber/camera");
  EXPECT_STREQ(status->last_error, "");
  ASSERT_EQ(elements_of(status->dropped_by_cause).size(), 2U);
  EXPECT_STREQ(elements_of(status->dropped_by_cause)[1].cause, "other");
  EXPECT_EQ(elements_of(status->rejected_by_cause)[0].count, 5U);
  EXPECT_EQ(cdr_of(*status), bytes);
}

// The list's few numbers, each turned round by hand.
TEST(Cdr, OfTheOtherByteOrderIsRead) {
  const CdrBytes little = cdr_of(SegmentList{});
  CdrBytes big = little;
  big[1] = std::byte{0};
  big[4 + 7] = std::byte{5};           // frame_id, 8 bytes
  big[4 + 11] = std::byte{6};          // epoch, 4 bytes
  const std::size_t end = big.size();  // ..., segmentation_ms, 4 bytes
  big[end - 4] = std::byte{0x41}, big[end - 3] = std::byte{0x20};
  const Sample<SegmentList> list(sample_of_cdr<SegmentList>(big));
  EXPECT_EQ(list->header.frame_id, 5U);
  EXPECT_EQ(list->header.epoch, 6U);
  EXPECT_EQ(list->segmentation_ms, 10.0F);
}

TEST(Cdr, MayEndWithThePaddingOfRtpsButNotWithMore) {
  CdrBytes bytes = status_bytes();
  bytes.resize(bytes.size() + 3);
  EXPECT_NO_THROW((void)sample_of_cdr<NodeStatus>(bytes));
  bytes.resize(bytes.size() + 1);
  EXPECT_THROW((void)sample_of_cdr<NodeStatus>(bytes), CdrError);
}

TEST(Cdr, OfAnotherEncodingIsRefusedByName) {
  for (const int encoding : {2, 3, 6, 7, 8, 9, 10, 11, 255}) {
    CdrBytes bytes = list_bytes();
    bytes[1] = static_cast<std::byte>(encoding);
    try {
      (void)sample_of_cdr<SegmentList>(bytes);
      ADD_FAILURE() << encoding;
    } catch (const CdrError& error) {
      EXPECT_STREQ(error.what(),
                   "these bytes are no cleave::v1::SegmentList: the encapsulation is not that of "
                   "XCDR1");
    }
  }
}

template <class T>
void expect_every_cut_is_refused(const CdrBytes& bytes, std::size_t step) {
  for (std::size_t size = 0; size < bytes.size(); size += step) {
    const CdrBytes cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_THROW((void)sample_of_cdr<T>(cut), CdrError) << size << " of " << bytes.size();
  }
}

TEST(Cdr, ThatIsCutOffAnywhereIsRefused) {
  expect_every_cut_is_refused<SegmentList>(list_bytes(), 1);
  expect_every_cut_is_refused<NodeStatus>(status_bytes(), 1);
  expect_every_cut_is_refused<DepthCloud>(bulk_bytes<DepthCloud>(), 99'991);
  expect_every_cut_is_refused<LabelMap>(bulk_bytes<LabelMap>(), 9'973);
}

// A few bytes become others: a sample, or a refusal; the sanitizers see the rest. What is read can
// be written again.
template <class T>
void damage(const CdrBytes& whole, std::size_t reach) {
  std::mt19937 random(7);
  const auto below = [&](std::size_t limit) { return static_cast<std::size_t>(random() % limit); };
  std::size_t read = 0;
  for (int mutation = 0; mutation < 1000; ++mutation) {
    CdrBytes bytes = whole;
    for (std::size_t changes = 1 + below(3); changes > 0; --changes) {
      static constexpr std::array telling = {0x00, 0x01, 0x7F, 0x80, 0xFF};
      const auto value =
          below(2) == 0 ? telling[below(telling.size())] : static_cast<int>(below(256));
      bytes[below(std::min(reach, bytes.size()))] = static_cast<std::byte>(value);
    }
    if (below(4) == 0) bytes.resize(below(bytes.size()));
    try {
      const Sample<T> sample(sample_of_cdr<T>(bytes));
      ASSERT_FALSE(cdr_of(*sample).empty());
      ++read;
    } catch (const CdrError&) {
      continue;
    }
  }
  EXPECT_GT(read, 0U);
  EXPECT_LT(read, 1000U);
}

TEST(Cdr, ThatIsDamagedIsReadOrRefused) {
  damage<SegmentList>(list_bytes(), SIZE_MAX);
  damage<NodeStatus>(status_bytes(), SIZE_MAX);
  damage<DepthCloud>(bulk_bytes<DepthCloud>(), 400);  // behind its header are numbers alone
  damage<LabelMap>(bulk_bytes<LabelMap>(), 400);
}

TEST(Cdr, ThatAnnouncesMoreThanItHoldsIsRefusedBeforeMemoryIsAskedFor) {
  const CdrBytes whole = cdr_of(SegmentList{});
  const std::size_t count = whole.size() - 16;  // of segments; then borders and two floats
  for (const int high : {0x00, 0x01, 0x7F, 0xFF}) {
    CdrBytes bytes = whole;
    bytes[count] = std::byte{0xFF};
    bytes[count + 3] = static_cast<std::byte>(high);
    EXPECT_THROW((void)sample_of_cdr<SegmentList>(bytes), CdrError);
  }
}

}  // namespace
}  // namespace cleave
