// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/frames/frame_joiner.hpp"

#include <dds/dds.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "libcleave/internal/topic.hpp"

namespace cleave {
namespace {

template <class T>
RawSample raw_part(std::uint32_t epoch, std::uint64_t frame_id) {
  void* const memory = dds_alloc(sizeof(T));
  static_cast<T*>(memory)->header.epoch = epoch;
  static_cast<T*>(memory)->header.frame_id = frame_id;
  return {nullptr, memory, memory, topic_of<T>("x").descriptor};
}
CloudSample cloud_of(std::uint64_t frame_id, std::uint32_t epoch = 1) {
  return {raw_part<DepthCloud>(epoch, frame_id), false};
}
LabelSample labels_of(std::uint64_t frame_id, std::uint32_t epoch = 1) {
  return {raw_part<LabelMap>(epoch, frame_id), false};
}
ListSample list_of(std::uint64_t frame_id, std::uint32_t epoch = 1) {
  return ListSample(Sample<SegmentList>(raw_part<SegmentList>(epoch, frame_id)));
}

TEST(FrameJoiner, CompletesAFrameInWhicheverOrderItsPartsCome) {
  std::array<int, 3> order = {0, 1, 2};
  do {
    FrameJoiner joiner;
    for (std::size_t i = 0; i < order.size(); ++i) {
      const auto frame = order[i] == 0   ? joiner.add(cloud_of(5))
                         : order[i] == 1 ? joiner.add(labels_of(5))
                                         : joiner.add(list_of(5));
      ASSERT_EQ(frame.has_value(), i == 2);
      if (!frame) continue;
      EXPECT_EQ(frame->cloud.header().frame_id, 5U);
      EXPECT_EQ(frame->labels.header().frame_id, 5U);
      EXPECT_EQ(frame->list.header().frame_id, 5U);
    }
    EXPECT_EQ(joiner.given_up(), 0U);
  } while (std::ranges::next_permutation(order).found);
}

TEST(FrameJoiner, DoesNotJoinAcrossEpochs) {
  FrameJoiner joiner;
  EXPECT_FALSE(joiner.add(cloud_of(5, 1)));
  EXPECT_FALSE(joiner.add(labels_of(5, 1)));
  EXPECT_FALSE(joiner.add(list_of(5, 2)));
}

TEST(FrameJoiner, GivesUpWhatIsOlderThanACompleteFrame) {
  FrameJoiner joiner;
  EXPECT_FALSE(joiner.add(list_of(1)));  // rejected: no labels come
  EXPECT_FALSE(joiner.add(cloud_of(1)));
  EXPECT_FALSE(joiner.add(cloud_of(2)));
  EXPECT_FALSE(joiner.add(labels_of(2)));
  EXPECT_TRUE(joiner.add(list_of(2)));
  EXPECT_EQ(joiner.given_up(), 2U);
  EXPECT_FALSE(joiner.add(labels_of(1)));
}

TEST(FrameJoiner, GivesUpWhatIsLeftOfAnEpochThatIsOver) {
  FrameJoiner joiner;
  EXPECT_FALSE(joiner.add(cloud_of(90, 1)));
  EXPECT_FALSE(joiner.add(list_of(90, 1)));
  EXPECT_FALSE(joiner.add(list_of(1, 2)));
  EXPECT_FALSE(joiner.add(cloud_of(1, 2)));
  EXPECT_TRUE(joiner.add(labels_of(1, 2)));
  EXPECT_EQ(joiner.given_up(), 2U);
}

TEST(FrameJoiner, HoldsFewFramesWhoseListDoesNotCome) {
  FrameJoiner joiner;
  for (std::uint64_t id = 1; id <= 10; ++id) {
    EXPECT_FALSE(joiner.add(cloud_of(id)));
    EXPECT_FALSE(joiner.add(labels_of(id)));
  }
  EXPECT_EQ(joiner.given_up(), 16U);
  EXPECT_TRUE(joiner.add(list_of(9)));
}

TEST(FrameJoiner, HoldsFewListsWhoseFrameDoesNotCome) {
  FrameJoiner joiner;
  for (std::uint64_t id = 1; id <= 10; ++id) EXPECT_FALSE(joiner.add(list_of(id)));
  EXPECT_EQ(joiner.given_up(), 2U);
}

}  // namespace
}  // namespace cleave
