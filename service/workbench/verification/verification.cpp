// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/verification/verification.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "recording/error.hpp"
#include "recording/frames/frame_writer.hpp"
#include "recording/ros/open_frames.hpp"

namespace cleave::workbench {
namespace {

// Enough for every worker to be busy until the last one has done.
constexpr std::size_t clouds_a_worker = 4;

struct Segmented {
  std::int64_t log_time_ns;
  SegmentedCloud result;
};

std::string size_problem(const recording::FrameHeader& header) {
  return "frame " + std::to_string(header.frame_id) + " has " + std::to_string(header.width) +
         " x " + std::to_string(header.height) + " points, more than " + capacity_text();
}

// Clouds of a recording that were not segmented, and why.
struct LeftOut {
  std::vector<std::string> unread;
  std::vector<std::string> too_large;
};

// Calls on_frame for every other cloud of the recording, in order.
LeftOut segment_all(const recording::FileTopic& input, OfflineSegmenter& segmenter,
                    const std::function<void(Segmented)>& on_frame,
                    const std::function<void(std::size_t)>& on_progress) {
  const auto reader = recording::open_frames(input, {recording::Kind::cloud});
  for (const std::string& remark : reader->remarks()) spdlog::warn("{}", remark);
  LeftOut left_out;
  std::size_t done = 0;
  bool more = true;
  while (more) {
    std::vector<std::int64_t> times_ns;
    std::vector<recording::Cloud> clouds;
    while (clouds.size() < clouds_a_worker * segmenter.workers()) {
      auto frame = reader->next();
      more = frame.has_value();
      if (!more) break;
      if (frame->header().points() > capacity_points) {
        left_out.too_large.push_back(size_problem(frame->header()));
        continue;
      }
      times_ns.push_back(frame->log_time_ns);
      clouds.push_back(std::get<recording::Cloud>(std::move(frame->content)));
    }
    std::vector<SegmentedCloud> results = segmenter.segment(clouds, input.file.string());
    for (std::size_t i = 0; i < results.size(); ++i) {
      on_frame({times_ns[i], std::move(results[i])});
    }
    done += results.size();
    on_progress(done);
  }
  left_out.unread = reader->problems();
  return left_out;
}

}  // namespace

VerificationResult verify(const recording::FileTopic& input, const std::filesystem::path& golden,
                          OfflineSegmenter& segmenter, const Tolerances& tolerances,
                          const std::function<void(const FrameDifference&)>& on_difference,
                          const std::function<void(std::size_t)>& on_progress) {
  GoldenFrames expected(golden);
  VerificationResult result;
  const auto compare = [&](const Segmented& frame) {
    ++result.frames;
    const recording::FrameHeader& header = frame.result.labels.header;
    const auto known = expected.take(header);
    if (!known) {
      ++result.not_expected;
      on_difference({header, {"is not in " + golden.string()}});
      return;
    }
    std::vector<std::string> lines = differences(*known, frame.result, tolerances);
    if (lines.empty()) return;
    ++result.different;
    on_difference({header, std::move(lines)});
  };
  LeftOut left_out = segment_all(input, segmenter, compare, on_progress);
  result.problems = std::move(left_out.unread);
  std::ranges::move(left_out.too_large, std::back_inserter(result.problems));
  result.missing = expected.left();
  for (std::string& problem : expected.problems()) {
    result.problems.push_back(golden.string() + ": " + std::move(problem));
  }
  return result;
}

std::size_t write_golden(const recording::FileTopic& input, const std::filesystem::path& golden,
                         OfflineSegmenter& segmenter,
                         const std::function<void(std::size_t)>& on_progress) {
  std::filesystem::path partial = golden;
  partial += ".partial";
  std::size_t frames = 0;
  try {
    recording::FrameWriter writer(partial);
    const auto write = [&](Segmented frame) {
      writer.write({frame.log_time_ns, std::move(frame.result.labels)});
      writer.write({frame.log_time_ns, std::move(frame.result.list)});
      ++frames;
    };
    const LeftOut left_out = segment_all(input, segmenter, write, on_progress);
    if (!left_out.unread.empty()) {
      throw recording::FileError(input.file.string() +
                                 ": a cloud could not be read: " + left_out.unread.front() +
                                 "; `cleave recover` keeps what is intact");
    }
    if (!left_out.too_large.empty()) {
      throw recording::FileError(input.file.string() + ": " + left_out.too_large.front() +
                                 "; `cleave convert --decimate 2` makes four points into one");
    }
    if (frames == 0) {
      throw recording::FileError(
          input.file.string() + ": holds no cloud: a golden file of no frames would prove nothing");
    }
    writer.close();
    std::filesystem::rename(partial, golden);
  } catch (...) {
    std::error_code ignored;  // the failure that is reported is the first one
    std::filesystem::remove(partial, ignored);
    throw;
  }
  return frames;
}

}  // namespace cleave::workbench
