// SPDX-License-Identifier: BSD-3-Clause
// Clouds from a writer that is not our grabber: whatever it sends, the segmenter says what is
// wrong, counts it, and goes on.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "libcleave/writer.hpp"
#include "tests/integration/support/daemons.hpp"
#include "tests/integration/support/monitor.hpp"
#include "tests/integration/support/small_clouds.hpp"

namespace cleave::test {
namespace {

class ForeignWriter : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(segmenter_.logs("ready")) << segmenter_.log();
    ASSERT_TRUE(eventually([&] { return writer_.matched_readers() == 1; }));
  }

  // Publishes a good cloud of 80 x 60 points that `spoil` may change first.
  template <class Spoil>
  void publish(Spoil spoil) {
    auto cloud = writer_.loan();
    ASSERT_TRUE(cloud);
    FrameHeader& header = (*cloud)->header;
    header = FrameHeader{};
    header.frame_id = ++frame_id_;
    header.width = 80;
    header.height = 60;
    ASSERT_TRUE(set_name(header.sensor, "camera"));
    const std::vector<float> points = corner_points(80, 60);
    std::copy(points.begin(), points.end(), (*cloud)->xyz);
    spoil(**cloud);
    header.publication_time_ns = monotonic_now_ns();
    ASSERT_TRUE(writer_.publish(std::move(*cloud)));
  }

  // The list for the last published frame.
  ListSummary answer() {
    const bool came = eventually([&] {
      monitor_.poll();
      return !monitor_.lists().empty() && monitor_.lists().back().frame_id == frame_id_;
    });
    EXPECT_TRUE(came) << segmenter_.log();
    return came ? monitor_.lists().back() : ListSummary{};
  }

  template <class Spoil>
  void expect_rejected(cleave_v1_FrameOutcome outcome, Spoil spoil) {
    publish(spoil);
    const ListSummary list = answer();
    EXPECT_EQ(list.outcome, outcome);
    EXPECT_EQ(list.segments, 0U);
  }

  Daemons daemons_{11, false};
  Process segmenter_ = daemons_.segmenter();
  Monitor monitor_{11, "camera"};
  Writer<DepthCloud> writer_{monitor_.stream(), "camera"};
  std::uint64_t frame_id_ = 0;
};

TEST_F(ForeignWriter, IsServedAfterEveryKindOfBadCloudAndAllAreCounted) {
  using Cloud = DepthCloud;
  // 0 x 0
  expect_rejected(cleave_v1_OUTCOME_REJECTED_BAD_SIZE,
                  [](Cloud& c) { c.header.width = c.header.height = 0; });
  // sizes that disagree: a width without a height
  expect_rejected(cleave_v1_OUTCOME_REJECTED_BAD_SIZE, [](Cloud& c) { c.header.height = 0; });
  // more than 640 x 480 points, also where 32 bits overflow
  expect_rejected(cleave_v1_OUTCOME_REJECTED_BAD_SIZE, [](Cloud& c) {
    c.header.width = 641;
    c.header.height = 480;
  });
  expect_rejected(cleave_v1_OUTCOME_REJECTED_BAD_SIZE,
                  [](Cloud& c) { c.header.width = c.header.height = 0x10000; });
  // names
  expect_rejected(cleave_v1_OUTCOME_REJECTED_BAD_HEADER,
                  [](Cloud& c) { std::memset(c.header.sensor, 'x', sizeof c.header.sensor); });
  expect_rejected(cleave_v1_OUTCOME_REJECTED_BAD_HEADER,
                  [](Cloud& c) { ASSERT_TRUE(set_name(c.header.sensor, "other")); });
  // all points invalid
  expect_rejected(cleave_v1_OUTCOME_REJECTED_NO_FINITE_POINT, [](Cloud& c) {
    std::fill_n(c.xyz, 80 * 60 * 3, std::numeric_limits<float>::quiet_NaN());
  });
  expect_rejected(cleave_v1_OUTCOME_REJECTED_NO_FINITE_POINT, [](Cloud& c) {
    std::fill_n(c.xyz, 80 * 60 * 3, std::numeric_limits<float>::infinity());
  });

  publish([](Cloud&) {});
  EXPECT_EQ(answer().outcome, cleave_v1_OUTCOME_SEGMENTED);
  ASSERT_TRUE(eventually([&] {
    monitor_.poll();
    return monitor_.status("segmenter/camera").frames_in == 9;
  }));
  const NodeReport status = monitor_.status("segmenter/camera");
  EXPECT_EQ(status.frames_rejected, 8U);
  EXPECT_EQ(status.frames_out, 1U);
  EXPECT_EQ(status.frames_in, status.frames_out + status.frames_dropped + status.frames_rejected +
                                  status.frames_in_flight);
}

TEST_F(ForeignWriter, MaySendSomeNaNAndInfinitePoints) {
  publish([](DepthCloud& c) {
    for (int i = 0; i < 300; ++i) c.xyz[3 * i] = std::numeric_limits<float>::quiet_NaN();
    for (int i = 300; i < 600; ++i) c.xyz[3 * i + 2] = -std::numeric_limits<float>::infinity();
  });
  const ListSummary list = answer();
  EXPECT_EQ(list.outcome, cleave_v1_OUTCOME_SEGMENTED);
  EXPECT_GE(list.segments, 1U);
}

TEST_F(ForeignWriter, MaySendACloudOf1x1Points) {
  publish([](DepthCloud& c) { c.header.width = c.header.height = 1; });
  const ListSummary list = answer();
  EXPECT_EQ(list.outcome, cleave_v1_OUTCOME_SEGMENTED);
  EXPECT_EQ(list.segments, 1U);
}

TEST_F(ForeignWriter, SeesAGapInItsFrameIdsCountedAsDroppedInTransport) {
  publish([](DepthCloud&) {});
  (void)answer();
  frame_id_ += 3;
  publish([](DepthCloud&) {});
  (void)answer();
  ASSERT_TRUE(eventually([&] {
    monitor_.poll();
    return monitor_.status("segmenter/camera").frames_in == 5;
  }));
  EXPECT_EQ(monitor_.status("segmenter/camera").frames_dropped, 3U);
}

}  // namespace
}  // namespace cleave::test
