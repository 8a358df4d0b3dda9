// SPDX-License-Identifier: BSD-3-Clause
// What drives the pipeline without DDS: clouds from memory, segmenters that leave a trace, and a
// sink that remembers.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <random>
#include <thread>
#include <vector>

#include "segmenter/pipeline/frame_pipeline.hpp"

namespace cleave::service::test {

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

  [[nodiscard]] std::unique_ptr<LabelMemory> loan_labels(std::uint64_t /*points*/) override {
    if (exhausted) return nullptr;
    return std::make_unique<Loan>(*this);
  }
  [[nodiscard]] std::string no_memory() const override { return "the sink is exhausted"; }
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
  class Loan : public LabelMemory {
   public:
    explicit Loan(FakeSink& sink) : sink_(sink) {
      const int now = ++sink_.loans;
      int most = sink_.most_loans;
      while (now > most && !sink_.most_loans.compare_exchange_weak(most, now)) {
      }
    }
    ~Loan() override { --sink_.loans; }
    [[nodiscard]] FrameHeader& header() override { return map_->header; }
    [[nodiscard]] std::int64_t& cloud_publication_time_ns() override {
      return map_->cloud_publication_time_ns;
    }
    [[nodiscard]] std::span<std::uint16_t> room() override { return map_->label; }
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

inline std::shared_ptr<DepthCloud> cloud(std::uint64_t frame_id) {
  // Zeroing the room for all points would dominate the test under the thread sanitizer.
  auto made = std::make_shared_for_overwrite<DepthCloud>();
  made->header = {};
  made->header.frame_id = frame_id;
  made->header.width = 4;
  made->header.height = 3;
  made->header.publication_time_ns = monotonic_now_ns();
  std::fill_n(made->xyz, 3 * 4 * 3, 0.0F);
  made->xyz[0] = static_cast<float>(frame_id);
  EXPECT_TRUE(set_name(made->header.sensor, "camera"));
  return made;
}

inline ReceivedCloud received(std::shared_ptr<const DepthCloud> sample, bool zero_copy) {
  const DepthCloud& cloud = *sample;
  return {std::move(sample), &cloud.header, cloud.xyz, zero_copy};
}

// Labels the first point with the cloud's first coordinate, and finds one segment.
inline Outcome echo(const CloudView& view, std::span<std::uint16_t> labels, Segmentation& result) {
  std::fill(labels.begin(), labels.end(), std::uint16_t{0});
  labels[0] = static_cast<std::uint16_t>(view.point(0)[0]);
  result.segments.resize(1);
  return Outcome::segmented;
}

inline SegmentFunction echo_after_random_time(unsigned seed) {
  return [random = std::mt19937(seed)](const CloudView& view, std::span<std::uint16_t> labels,
                                       Segmentation& result) mutable {
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 2000));
    return echo(view, labels, result);
  };
}

inline std::vector<SegmentFunction> random_workers(unsigned count) {
  std::vector<SegmentFunction> workers;
  for (unsigned i = 0; i < count; ++i) workers.push_back(echo_after_random_time(i));
  return workers;
}

inline void expect_balanced(const FrameCounts& counts) {
  EXPECT_EQ(counts.received,
            counts.published + counts.dropped_total() + counts.rejected_total() + counts.in_flight);
}

}  // namespace cleave::service::test
