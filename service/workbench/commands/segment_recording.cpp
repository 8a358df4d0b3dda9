// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/commands/segment_recording.hpp"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <filesystem>
#include <iostream>
#include <optional>
#include <string_view>
#include <utility>

#include "console/command.hpp"
#include "console/json.hpp"
#include "recording/pcd/writer.hpp"
#include "recording/sources/frame_sink.hpp"
#include "recording/sources/frame_source.hpp"
#include "segmentation/result_check.hpp"
#include "segmentation/segmenter.hpp"
#include "workbench/cloud/pcd_view.hpp"
#include "workbench/cloud/recorded_segments.hpp"
#include "workbench/cloud/why_not_segmented.hpp"

namespace cleave::workbench {
namespace {

using recording::PcdCloud;
using segmentation::Segmentation;

// Label maps and segment lists of the recording are passed over: they are made anew.
std::optional<recording::Cloud> next_cloud(recording::FrameSource& source) {
  while (auto frame = source.next()) {
    if (auto* const cloud = std::get_if<recording::Cloud>(&frame->content)) {
      return std::move(*cloud);
    }
  }
  return std::nullopt;
}

class RecordingRun {
 public:
  explicit RecordingRun(const RecordingToSegment& recording)
      : recording_(recording), segmenter_(recording.options) {}

  int run() {
    const auto source = recording::open_frame_source(recording_.input, "camera", recording_.unit);
    recording::refuse_existing(recording_.output);
    while (const auto cloud = next_cloud(*source)) segment(*cloud);
    report(source->skipped() + failed_);
    return written_ == 0 || source->skipped() + failed_ > 0 ? exit_failed : exit_done;
  }

 private:
  void segment(const recording::Cloud& cloud) {
    const std::uint32_t width = cloud.header.width;
    const std::uint32_t height = cloud.header.height;
    PcdCloud pcd = PcdCloud::of_points(cloud.xyz, width, height);
    std::vector<std::uint16_t> labels(pcd.header().points());
    segmentation::CloudView view = view_of(pcd);
    view.pose = recording_.pose;
    Segmentation result;
    const std::string_view why = why_not_segmented(segmenter_.segment(view, labels, result));
    if (!why.empty()) {
      spdlog::warn("frame {}: not segmented: {}", cloud.header.frame_id, why);
      ++failed_;
      return;
    }
    advise(cloud.header.frame_id, result);
    pcd.set_labels(labels);
    std::filesystem::create_directories(recording_.output);
    const std::filesystem::path file =
        std::filesystem::path(recording_.output) / fmt::format("frame_{:06}.pcd", ++written_);
    write_pcd(file, pcd);
    if (recording_.json) {
      Json frame = {{"output", file.string()}, {"points", labels.size()}};
      frame.update(segments_json(result));
      frames_.push_back(std::move(frame));
    } else {
      std::cout << fmt::format("{}: {} points, {} segments\n", file.string(), labels.size(),
                               result.segments.size());
    }
  }

  // Said once, for all frames are of one camera.
  void advise(std::uint64_t frame, const Segmentation& result) {
    const std::string_view advice = segmentation::advice_on(segmentation::doubt_about(result));
    if (advice.empty() || std::exchange(advised_, true)) return;
    spdlog::warn("{}, frame {}: {}", recording_.input, frame, advice);
  }

  void report(std::size_t lost) const {
    if (recording_.json) {
      std::cout << one_line({{"input", recording_.input},
                             {"output", recording_.output},
                             {"frames", frames_},
                             {"not_segmented", lost}})
                << '\n';
    } else {
      std::cout << fmt::format("{}: {} frames segmented, {} not\n", recording_.output, written_,
                               lost);
    }
  }

  const RecordingToSegment& recording_;
  segmentation::Segmenter segmenter_;
  std::size_t written_ = 0;
  std::size_t failed_ = 0;
  bool advised_ = false;
  Json frames_ = Json::array();  // for --json, which prints one object
};

}  // namespace

int segment_recording(const RecordingToSegment& recording) {
  return RecordingRun(recording).run();
}

PcdCloud frame_of_recording(const std::string& input, std::optional<recording::Unit> unit,
                            std::uint64_t number) {
  const auto source = recording::open_frame_source(input, "camera", unit);
  std::uint64_t count = 0;
  while (const auto cloud = next_cloud(*source)) {
    if (++count < number) continue;
    return PcdCloud::of_points(cloud->xyz, cloud->header.width, cloud->header.height);
  }
  throw std::runtime_error(input + ": has " + std::to_string(count) +
                           " frames that can be read; frame " + std::to_string(number) +
                           " is not one of them");
}

}  // namespace cleave::workbench
