// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <utility>

#include "libcleave/cloud_writer.hpp"
#include "libcleave/writer.hpp"
#include "tests/unit/c/c_stream.hpp"

namespace cleave {
namespace {

class FramesOfC : public test::CStream {
 protected:
  FramesOfC() { EXPECT_EQ(cleave_frames_open(stream_, sensor_.c_str(), &frames_), CLEAVE_OK); }
  ~FramesOfC() override {
    release();
    cleave_frames_close(frames_);
  }
  cleave_result next(int timeout_ms) {
    return cleave_frames_next(frames_, timeout_ms, &cloud_, &labels_, &segments_);
  }
  void release() {
    for (cleave_sample** const sample : {&cloud_, &labels_, &segments_}) {
      cleave_release(std::exchange(*sample, nullptr));
    }
  }

  cleave_frames* frames_ = nullptr;
  cleave_sample* cloud_ = nullptr;
  cleave_sample* labels_ = nullptr;
  cleave_sample* segments_ = nullptr;
};

template <class Loan>
void publish(std::optional<Loan> loan, std::uint64_t frame_id) {
  ASSERT_TRUE(loan);
  loan->header() = FrameHeader{};
  loan->header().frame_id = frame_id;
  ASSERT_TRUE(std::move(*loan).publish());
}

TEST_F(FramesOfC, AreACloudItsLabelsAndItsList) {
  CloudWriter clouds(cpp_stream(), sensor_);
  LabelWriter labels(cpp_stream(), sensor_);
  Writer<SegmentList> lists(cpp_stream(), sensor_);
  ASSERT_TRUE(test::eventually([&] {
    return clouds.matched_readers() == 1 && labels.matched_readers() == 1 &&
           lists.matched_readers() == 1;
  }));
  SegmentList list{};
  for (list.header.frame_id = 1; list.header.frame_id <= 3; ++list.header.frame_id) {
    ASSERT_TRUE(lists.publish(list));
    publish(clouds.loan(1), list.header.frame_id);
    if (list.header.frame_id == 2) continue;  // its labels are lost
    publish(labels.loan(1), list.header.frame_id);
    ASSERT_TRUE(test::eventually([&] { return test::is_readable(cleave_frames_fd(frames_)); }));
    ASSERT_EQ(next(10'000), CLEAVE_OK) << cleave_error();
    for (const cleave_sample* const sample : {cloud_, labels_, segments_}) {
      EXPECT_EQ(cleave_sample_header(sample)->frame_id, list.header.frame_id);
    }
    EXPECT_EQ(cleave_sample_kind(cloud_), CLEAVE_CLOUD);
    EXPECT_EQ(cleave_sample_kind(labels_), CLEAVE_LABELS);
    EXPECT_EQ(cleave_sample_kind(segments_), CLEAVE_SEGMENTS);
    release();
    EXPECT_EQ(next(0), CLEAVE_TIMEOUT);
    EXPECT_FALSE(test::is_readable(cleave_frames_fd(frames_)));
  }
  EXPECT_EQ(cleave_frames_given_up(frames_), 2U);
}

TEST_F(FramesOfC, ThatDoNotComeAreToldWithWhoIsMissing) {
  EXPECT_EQ(next(1), CLEAVE_TIMEOUT);
  EXPECT_STREQ(cleave_error(), "no frame came in time: nobody publishes the sensor's clouds");
  const CloudWriter clouds(cpp_stream(), sensor_);
  EXPECT_TRUE(test::eventually([&] {
    (void)next(1);
    return std::string(cleave_error()) ==
           "no frame came in time: clouds are published, but nobody segments them";
  }));
  const Writer<SegmentList> lists(cpp_stream(), sensor_);
  EXPECT_TRUE(test::eventually([&] {
    (void)next(1);
    return std::string(cleave_error()) == "no frame was complete in time";
  }));
}

TEST_F(FramesOfC, AreRefusedForASensorThatCannotBe) {
  cleave_frames* frames = nullptr;
  EXPECT_EQ(cleave_frames_open(stream_, "a b", &frames), CLEAVE_BAD_ARGUMENT);
  EXPECT_EQ(frames, nullptr);
}

}  // namespace
}  // namespace cleave
