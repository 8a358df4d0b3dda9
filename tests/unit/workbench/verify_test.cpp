// SPDX-License-Identifier: BSD-3-Clause
// `cleave verify`: one changed label in 300 frames is found, with any number of workers.
#include "workbench/verification/verification.hpp"

#include <gtest/gtest.h>

#include "recording/frames/frame_writer.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/recording/recording_files.hpp"

namespace cleave::workbench {
namespace {

constexpr std::size_t frames = 300;

class Verify : public testing::Test {
 protected:
  Verify() {
    recording::FrameWriter writer(input_);
    for (std::uint64_t id = 1; id <= frames; ++id) {
      writer.write({static_cast<std::int64_t>(id), recording::depth_cloud(id)});
    }
    writer.close();
    OfflineSegmenter segmenter({}, 2);
    EXPECT_EQ(write_golden({input_}, golden_, segmenter, [](std::size_t) {}), frames);
  }

  VerificationResult run(std::size_t workers, const Tolerances& tolerances = {}) {
    OfflineSegmenter segmenter({}, workers);
    return verify(
        {input_}, golden_, segmenter, tolerances,
        [this](const FrameDifference& difference) { found_.push_back(difference); },
        [](std::size_t) {});
  }

  // Writes the golden file anew with every frame passed through `change`; empty: left out.
  template <class Change>
  void change_golden(const Change& change) {
    std::vector<recording::Frame> golden = recording::read_frames(golden_);
    recording::FrameWriter writer(golden_);
    for (recording::Frame& frame : golden) {
      if (change(frame)) writer.write(frame);
    }
    writer.close();
  }
  void change_one_label() {
    change_golden([](recording::Frame& frame) {
      auto* const labels = std::get_if<recording::Labels>(&frame.content);
      if (labels != nullptr && labels->header.frame_id == 217) ++labels->label[3 * 32 + 5];
      return true;
    });
  }

  tests::TemporaryFolder folder_;
  const std::filesystem::path input_ = folder_.path() / "input.mcap";
  const std::filesystem::path golden_ = folder_.path() / "golden.mcap";
  std::vector<FrameDifference> found_;
};

TEST_F(Verify, PassesOnTheUnchangedFileWith1And4Workers) {
  for (const std::size_t workers : {1U, 4U}) {
    const VerificationResult result = run(workers);
    EXPECT_TRUE(result.passed()) << workers;
    EXPECT_EQ(result.frames, frames);
  }
}

TEST_F(Verify, FindsOneChangedLabelIn300FramesWith1And4Workers) {
  change_one_label();
  for (const std::size_t workers : {1U, 4U}) {
    found_.clear();
    const VerificationResult result = run(workers);
    EXPECT_FALSE(result.passed());
    EXPECT_EQ(result.different, 1U);
    ASSERT_EQ(found_.size(), 1U);
    EXPECT_EQ(found_[0].header.frame_id, 217U);
    ASSERT_EQ(found_[0].lines.size(), 1U);
    EXPECT_EQ(found_[0].lines[0].find("labels: 1 of 768 points differ, the first at column 5, "
                                      "row 3"),
              0U)
        << found_[0].lines[0];
  }
}

TEST_F(Verify, ForgivesAChangedLabelWithATolerance) {
  change_one_label();
  EXPECT_TRUE(run(2, {.points_share = 0.01, .distance_m = 0.001}).passed());
}

TEST_F(Verify, TellsWhatChangedInASegment) {
  change_golden([](recording::Frame& frame) {
    auto* const list = std::get_if<recording::SegmentList>(&frame.content);
    if (list == nullptr || list->header.frame_id != 3 || list->segments.empty()) return true;
    list->segments[0].box.centre.x += 0.25F;
    return true;
  });
  EXPECT_FALSE(run(2).passed());
  ASSERT_EQ(found_.size(), 1U);
  EXPECT_EQ(found_[0].lines.at(0), "segment 1: its box's centre is off by 250 mm");
}

TEST_F(Verify, NamesTheFieldsOfASegmentThatAreNotTheSame) {
  change_golden([](recording::Frame& frame) {
    auto* const list = std::get_if<recording::SegmentList>(&frame.content);
    if (list == nullptr || list->header.frame_id != 3 || list->segments.empty()) return true;
    list->segments[0].mean_normal.x += 0.25F;
    list->segments[0].planarity /= 2;
    return true;
  });
  EXPECT_FALSE(run(2).passed());
  ASSERT_EQ(found_.size(), 1U);
  EXPECT_EQ(found_[0].lines.at(0), "segment 1: not the same mean_normal, planarity");
}

TEST_F(Verify, FindsFramesThatAreMissingOnEitherSide) {
  change_golden([](const recording::Frame& frame) { return frame.header().frame_id != 5; });
  const VerificationResult result = run(2);
  EXPECT_EQ(result.not_expected, 1U);
  std::filesystem::remove(input_);
  recording::FrameWriter writer(input_);
  writer.write({1, recording::depth_cloud(1)});
  writer.close();
  EXPECT_EQ(run(2).missing, frames - 2);
}

TEST_F(Verify, WritesTheSameGoldenFileAgain) {
  const recording::Bytes before = recording::read_all(golden_);
  OfflineSegmenter segmenter({}, 4);
  (void)write_golden({input_}, golden_, segmenter, [](std::size_t) {});
  EXPECT_EQ(recording::read_all(golden_), before);
}

}  // namespace
}  // namespace cleave::workbench
