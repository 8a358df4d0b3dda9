// The whole pipeline with clouds from memory, segmenters of random duration and a sink that
// remembers: what the daemon does but for DDS.
#include "segmenter/frame_pipeline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace cleave::service {
namespace {

using segmentation::CloudView;
using segmentation::Outcome;
using segmentation::Segmentation;

// Remembers what was published; loans at most as many label maps as a DDS writer does.
class FakeSink : public ResultSink {
 public:
  struct List {
    std::uint64_t frame_id;
    cleave_v1_FrameOutcome outcome;
    std::uint32_t segments;
    std::string sensor;
  };

  [[nodiscard]] std::unique_ptr<LabelLoan> loan_labels() override {
    if (exhausted) return nullptr;
    return std::make_unique<Loan>(*this);
  }
  [[nodiscard]] bool publish(const SegmentList& list) override {
    if (refuses) return false;
    lists.push_back({list.header.frame_id, list.outcome, list.segments._length,
                     std::string(name_of(list.header.sensor))});
    return true;
  }
  [[nodiscard]] std::vector<std::uint64_t> list_ids() const {
    std::vector<std::uint64_t> ids;
    for (const List& list : lists) ids.push_back(list.frame_id);
    return ids;
  }

  std::atomic<bool> exhausted{false};
  std::atomic<bool> refuses{false};
  std::atomic<int> loans{0};
  std::atomic<int> most_loans{0};
  std::vector<List> lists;               // one thread at a time publishes
  std::vector<std::uint64_t> label_ids;  // as above
  std::vector<std::uint16_t> first_labels;

 private:
  class Loan : public LabelLoan {
   public:
    explicit Loan(FakeSink& sink) : sink_(sink) {
      const int now = ++sink_.loans;
      int most = sink_.most_loans;
      while (now > most && !sink_.most_loans.compare_exchange_weak(most, now)) {
      }
    }
    ~Loan() override { --sink_.loans; }
    [[nodiscard]] LabelMap& map() override { return *map_; }
    [[nodiscard]] bool publish() override {
      sink_.label_ids.push_back(map_->header.frame_id);
      sink_.first_labels.push_back(map_->label[0]);
      return true;
    }

   private:
    FakeSink& sink_;
    std::unique_ptr<LabelMap> map_ = std::make_unique_for_overwrite<LabelMap>();
  };
};

std::shared_ptr<DepthCloud> cloud(std::uint64_t frame_id) {
  // Zeroing all points would dominate the test under the thread sanitizer.
  auto made = std::make_shared_for_overwrite<DepthCloud>();
  made->header = {};
  made->header.frame_id = frame_id;
  made->header.width = 4;
  made->header.height = 3;
  made->header.publication_time_ns = monotonic_now_ns();
  made->xyz[0] = static_cast<float>(frame_id);
  EXPECT_TRUE(set_name(made->header.sensor, "camera"));
  return made;
}

// Labels the first point with the cloud's first coordinate, and finds one segment.
Outcome echo(const CloudView& view, std::span<std::uint16_t> labels, Segmentation& result) {
  std::fill(labels.begin(), labels.end(), std::uint16_t{0});
  labels[0] = static_cast<std::uint16_t>(view.point(0)[0]);
  result.segments.resize(1);
  return Outcome::segmented;
}

SegmentFunction echo_after_random_time(unsigned seed) {
  return [random = std::mt19937(seed)](const CloudView& view, std::span<std::uint16_t> labels,
                                       Segmentation& result) mutable {
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 2000));
    return echo(view, labels, result);
  };
}

std::vector<SegmentFunction> random_workers(unsigned count) {
  std::vector<SegmentFunction> workers;
  for (unsigned i = 0; i < count; ++i) workers.push_back(echo_after_random_time(i));
  return workers;
}

void expect_balanced(const FrameCounts& counts) {
  EXPECT_EQ(counts.received,
            counts.published + counts.dropped_total() + counts.rejected_total() + counts.in_flight);
}

class FramePipelineWorkers : public testing::TestWithParam<unsigned> {};
INSTANTIATE_TEST_SUITE_P(Counts, FramePipelineWorkers, testing::Values(1, 2, 4, 6));

TEST_P(FramePipelineWorkers, PublishEveryFrameOf200InOrderInLosslessMode) {
  FakeSink sink;
  FramePipeline pipeline({"camera", Mode::lossless, 8}, sink, random_workers(GetParam()));

  std::vector<std::uint64_t> sent;
  for (std::uint64_t id = 1; id <= 200; ++id) {
    pipeline.accept(cloud(id), true);
    sent.push_back(id);
    expect_balanced(pipeline.counts());
  }
  pipeline.drain();

  EXPECT_EQ(sink.list_ids(), sent);
  EXPECT_EQ(sink.label_ids, sent);
  EXPECT_TRUE(std::equal(sent.begin(), sent.end(), sink.first_labels.begin()));
  EXPECT_EQ(pipeline.counts().published, 200U);
  EXPECT_EQ(pipeline.counts().zero_copy, 200U);
  EXPECT_EQ(pipeline.counts().in_flight, 0U);
  EXPECT_LE(sink.most_loans, static_cast<int>(ResultSink::max_loans));
}

TEST_P(FramePipelineWorkers, KeepOrderAndBooksInLiveModeWhenOverrun) {
  FakeSink sink;
  FramePipeline pipeline({"camera", Mode::live, 2}, sink, random_workers(GetParam()));

  for (std::uint64_t id = 1; id <= 200; ++id) {
    pipeline.accept(cloud(id), true);
    if (id % 4 == 0) std::this_thread::sleep_for(std::chrono::microseconds(500));
    expect_balanced(pipeline.counts());
  }
  pipeline.drain();

  const std::vector<std::uint64_t> ids = sink.list_ids();
  EXPECT_TRUE(std::is_sorted(ids.begin(), ids.end()));
  EXPECT_EQ(ids.back(), 200U);
  const FrameCounts counts = pipeline.counts();
  EXPECT_EQ(counts.published, ids.size());
  EXPECT_EQ(counts.received, 200U);
  EXPECT_EQ(counts.published + counts.dropped_total(), 200U);
  EXPECT_EQ(counts.dropped_total(), counts.dropped.at(static_cast<std::size_t>(DropCause::queue)));
  EXPECT_LE(sink.most_loans, static_cast<int>(ResultSink::max_loans));
}

TEST(FramePipeline, AnswersABadSizeInItsPlaceInTheOrder) {
  FakeSink sink;
  FramePipeline pipeline({"camera", Mode::lossless, 8}, sink, random_workers(2));
  const auto bad = cloud(2);
  bad->header.width = 641;
  bad->header.height = 480;

  pipeline.accept(cloud(1), false);
  pipeline.accept(bad, false);
  pipeline.accept(cloud(3), false);
  pipeline.drain();

  EXPECT_EQ(sink.list_ids(), (std::vector<std::uint64_t>{1, 2, 3}));
  EXPECT_EQ(sink.lists[1].outcome, cleave_v1_OUTCOME_REJECTED_BAD_SIZE);
  EXPECT_EQ(sink.lists[1].segments, 0U);
  EXPECT_EQ(sink.label_ids, (std::vector<std::uint64_t>{1, 3}));
  EXPECT_EQ(pipeline.counts().rejected_total(), 1U);
  EXPECT_NE(pipeline.last_problem().find("bad size"), std::string::npos);
  expect_balanced(pipeline.counts());
}

TEST(FramePipeline, AnswersABadHeaderUnderTheSensorsName) {
  FakeSink sink;
  FramePipeline pipeline({"camera", Mode::lossless, 8}, sink, random_workers(1));
  const auto foreign = cloud(2);
  ASSERT_TRUE(set_name(foreign->header.sensor, "other"));

  for (const auto& frame : {cloud(1), foreign, cloud(3)}) pipeline.accept(frame, false);
  pipeline.drain();

  EXPECT_EQ(sink.lists.at(1).outcome, cleave_v1_OUTCOME_REJECTED_BAD_HEADER);
  EXPECT_EQ(sink.lists.at(1).sensor, "camera");
  EXPECT_EQ(pipeline.counts().received, 3U);
  EXPECT_EQ(pipeline.counts().published, 2U);
  EXPECT_EQ(pipeline.counts().dropped_total(), 0U);
}

TEST(FramePipeline, RejectsACloudWithoutAFinitePointAndPublishesNoLabelsForIt) {
  FakeSink sink;
  const SegmentFunction nothing_there = [](const CloudView&, std::span<std::uint16_t>,
                                           Segmentation&) { return Outcome::no_finite_point; };
  FramePipeline pipeline({"camera", Mode::live, 2}, sink, {nothing_there});

  pipeline.accept(cloud(1), false);
  pipeline.drain();

  ASSERT_EQ(sink.lists.size(), 1U);
  EXPECT_EQ(sink.lists[0].outcome, cleave_v1_OUTCOME_REJECTED_NO_FINITE_POINT);
  EXPECT_TRUE(sink.label_ids.empty());
  EXPECT_EQ(pipeline.counts().rejected_total(), 1U);
}

TEST(FramePipeline, SurvivesASegmenterThatThrows) {
  FakeSink sink;
  const SegmentFunction throws_on_two = [](const CloudView& view, std::span<std::uint16_t> labels,
                                           Segmentation& result) {
    if (view.point(0)[0] == 2) throw std::runtime_error("out of luck");
    return echo(view, labels, result);
  };
  FramePipeline pipeline({"camera", Mode::lossless, 8}, sink, {throws_on_two});

  for (std::uint64_t id = 1; id <= 3; ++id) pipeline.accept(cloud(id), false);
  pipeline.drain();

  EXPECT_EQ(sink.list_ids(), (std::vector<std::uint64_t>{1, 3}));
  EXPECT_EQ(pipeline.counts().dropped_total(), 1U);
  EXPECT_NE(pipeline.last_problem().find("out of luck"), std::string::npos);
}

TEST(FramePipeline, DropsAndCountsAFrameWhenNoChunkIsFree) {
  FakeSink sink;
  sink.exhausted = true;
  FramePipeline pipeline({"camera", Mode::live, 2}, sink, random_workers(1));

  pipeline.accept(cloud(1), false);
  pipeline.drain();

  EXPECT_TRUE(sink.lists.empty());
  EXPECT_EQ(pipeline.counts().dropped.at(static_cast<std::size_t>(DropCause::no_free_chunk)), 1U);
  expect_balanced(pipeline.counts());
}

TEST(FramePipeline, CountsAFrameAsDroppedWhenItsResultsAreRefused) {
  FakeSink sink;
  sink.refuses = true;
  FramePipeline pipeline({"camera", Mode::live, 2}, sink, random_workers(1));

  pipeline.accept(cloud(1), false);
  pipeline.drain();

  EXPECT_EQ(pipeline.counts().published, 0U);
  EXPECT_EQ(pipeline.counts().dropped.at(static_cast<std::size_t>(DropCause::refused_by_dds)), 1U);
}

// Holds frame 1 in its worker until the test opens the gate.
class Gate {
 public:
  SegmentFunction worker() {
    return [this](const CloudView& view, std::span<std::uint16_t> labels, Segmentation& result) {
      if (view.point(0)[0] == 1) {
        entered_ = true;
        while (!open_) std::this_thread::yield();
      }
      return echo(view, labels, result);
    };
  }
  void wait_until_entered() const {
    while (!entered_) std::this_thread::yield();
  }
  void open() { open_ = true; }

 private:
  std::atomic<bool> open_{false};
  std::atomic<bool> entered_{false};
};

TEST(FramePipeline, IgnoresAResendInFlightAndAnswersOneThatWasPublished) {
  FakeSink sink;
  Gate gate;
  FramePipeline pipeline({"camera", Mode::lossless, 8}, sink, {gate.worker()});

  pipeline.accept(cloud(1), false);
  gate.wait_until_entered();
  pipeline.accept(cloud(1), false);
  gate.open();
  while (pipeline.counts().in_flight > 0) std::this_thread::yield();
  pipeline.accept(cloud(1), false);
  pipeline.drain();

  EXPECT_EQ(sink.list_ids(), (std::vector<std::uint64_t>{1, 1}));
  EXPECT_EQ(pipeline.counts().received, 1U);
  EXPECT_EQ(pipeline.counts().published, 1U);
  EXPECT_EQ(pipeline.counts().duplicates, 2U);
}

TEST(FramePipeline, LetsGoOfTheCloudBeforeItsTurnToBePublishedComes) {
  FakeSink sink;
  Gate gate;
  FramePipeline pipeline({"camera", Mode::lossless, 8}, sink, {gate.worker(), gate.worker()});
  pipeline.accept(cloud(1), false);
  gate.wait_until_entered();
  auto second = cloud(2);
  const std::weak_ptr<const DepthCloud> watched = second;
  pipeline.accept(std::move(second), false);

  while (!watched.expired()) std::this_thread::yield();
  EXPECT_TRUE(sink.lists.empty());
  gate.open();
  pipeline.drain();

  EXPECT_EQ(sink.list_ids(), (std::vector<std::uint64_t>{1, 2}));
}

TEST(FramePipeline, HoldsNoMoreLoansThanAWriterHasWhileASlowFrameBlocksTheOrder) {
  FakeSink sink;
  Gate gate;
  FramePipeline pipeline({"camera", Mode::lossless, 8}, sink,
                         {gate.worker(), gate.worker(), gate.worker()});
  for (std::uint64_t id = 1; id <= 16; ++id) pipeline.accept(cloud(id), false);
  while (sink.loans < static_cast<int>(ResultSink::max_loans)) std::this_thread::yield();

  gate.open();
  pipeline.drain();

  EXPECT_EQ(sink.most_loans, static_cast<int>(ResultSink::max_loans));
  EXPECT_EQ(sink.lists.size(), 16U);
}

}  // namespace
}  // namespace cleave::service
