// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/verification/offline_segmenter.hpp"

#include <atomic>
#include <thread>
#include <utility>

#include "recording/units/suspected_unit.hpp"
#include "workbench/cloud/recorded_segments.hpp"

namespace cleave::workbench {
namespace {

using recording::FrameOutcome;

FrameOutcome outcome_of(segmentation::Outcome outcome) {
  switch (outcome) {
    case segmentation::Outcome::segmented:
      return FrameOutcome::segmented;
    case segmentation::Outcome::bad_size:
      return FrameOutcome::bad_size;
    case segmentation::Outcome::too_many_segments:
      return FrameOutcome::too_many_segments;
    case segmentation::Outcome::no_finite_point:
      break;
  }
  return FrameOutcome::no_finite_point;
}

SegmentedCloud segment_one(segmentation::Segmenter& segmenter, const recording::Cloud& cloud,
                           bool check_unit) {
  const recording::FrameHeader& header = cloud.header;
  SegmentedCloud result;
  result.labels = {header, header.publication_time_ns, {}};
  result.labels.label.resize(header.points());
  result.list.header = header;
  result.list.cloud_publication_time_ns = header.publication_time_ns;
  result.list.cloud_reception_time_ns = header.publication_time_ns;
  segmentation::Segmentation segmentation;
  const segmentation::CloudView view{
      .xyz = cloud.xyz.data(), .stride = 3, .width = header.width, .height = header.height};
  result.list.outcome = FrameOutcome::wrong_unit;
  if (!check_unit || !recording::suspected_unit(cloud.xyz)) {
    result.list.outcome = outcome_of(segmenter.segment(view, result.labels.label, segmentation));
  }
  set_segments(result.list, segmentation);
  return result;
}

}  // namespace

OfflineSegmenter::OfflineSegmenter(const segmentation::Options& options, std::size_t workers,
                                   std::optional<recording::Unit> unit)
    : unit_(unit) {
  for (std::size_t i = 0; i < workers; ++i) segmenters_.emplace_back(options);
}

std::vector<SegmentedCloud> OfflineSegmenter::segment(std::span<recording::Cloud> clouds,
                                                      const std::string& file) {
  if (!clouds.empty() && !std::exchange(has_cloud_, true) && !unit_) {
    recording::make_metres(clouds.front().xyz, unit_, file);
  }
  std::vector<SegmentedCloud> results(clouds.size());
  std::atomic<std::size_t> next{0};
  {
    std::vector<std::jthread> threads;
    for (segmentation::Segmenter& segmenter : segmenters_) {
      threads.emplace_back([&, worker = &segmenter] {
        for (std::size_t i = next++; i < clouds.size(); i = next++) {
          if (unit_) recording::scale_to_metres(clouds[i].xyz, *unit_);
          results[i] = segment_one(*worker, clouds[i], !unit_);
        }
      });
    }
  }
  return results;
}

}  // namespace cleave::workbench
