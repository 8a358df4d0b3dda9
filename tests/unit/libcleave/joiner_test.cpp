// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/frames/joiner.hpp"

#include <dds/dds.h>
#include <gtest/gtest.h>

#include <type_traits>

#include "libcleave/internal/topic.hpp"

namespace cleave {
namespace {

template <class T>
auto sample(std::uint32_t epoch, std::uint64_t frame_id) {
  using SampleType = std::conditional_t<std::is_same_v<T, DepthCloud>, CloudSample, LabelSample>;
  const auto* const descriptor = topic_of<T>("x").descriptor;
  void* const memory = dds_alloc(sizeof(T));
  static_cast<T*>(memory)->header.epoch = epoch;
  static_cast<T*>(memory)->header.frame_id = frame_id;
  return SampleType(RawSample(nullptr, memory, memory, descriptor), false);
}

TEST(Joiner, PairsACloudWithTheLabelsThatFollowIt) {
  Joiner joiner;
  EXPECT_FALSE(joiner.add(sample<DepthCloud>(1, 5)));
  const auto frame = joiner.add(sample<LabelMap>(1, 5));
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->cloud.header().frame_id, 5U);
  EXPECT_EQ(frame->labels.header().frame_id, 5U);
}

TEST(Joiner, PairsLabelsThatCameBeforeTheirCloud) {
  Joiner joiner;
  EXPECT_FALSE(joiner.add(sample<LabelMap>(1, 5)));
  EXPECT_TRUE(joiner.add(sample<DepthCloud>(1, 5)));
}

TEST(Joiner, DoesNotPairAcrossEpochs) {
  Joiner joiner;
  EXPECT_FALSE(joiner.add(sample<DepthCloud>(1, 5)));
  EXPECT_FALSE(joiner.add(sample<LabelMap>(2, 5)));
}

TEST(Joiner, GivesUpWhatIsOlderThanACompletedFrame) {
  Joiner joiner;
  EXPECT_FALSE(joiner.add(sample<DepthCloud>(1, 1)));
  EXPECT_FALSE(joiner.add(sample<DepthCloud>(1, 2)));
  EXPECT_TRUE(joiner.add(sample<LabelMap>(1, 2)));
  EXPECT_EQ(joiner.unpaired(), 1U);
  EXPECT_FALSE(joiner.add(sample<LabelMap>(1, 1)));
}

TEST(Joiner, HoldsNoMoreThanItsCapacity) {
  Joiner joiner(2);
  for (std::uint64_t id = 1; id <= 3; ++id) EXPECT_FALSE(joiner.add(sample<DepthCloud>(1, id)));
  EXPECT_EQ(joiner.unpaired(), 1U);
  EXPECT_FALSE(joiner.add(sample<LabelMap>(1, 1)));
  EXPECT_TRUE(joiner.add(sample<LabelMap>(1, 2)));
}

}  // namespace
}  // namespace cleave
