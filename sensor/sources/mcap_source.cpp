// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/sources/mcap_source.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <utility>

#include "recording/error.hpp"
#include "recording/ros/open_frames.hpp"
#include "recording/units/suspected_unit.hpp"
#include "sensor/sources/unusable_text.hpp"

namespace cleave::sensor {
namespace {

using recording::AheadFrame;
using recording::ReadAhead;

constexpr std::chrono::seconds first_frame_patience{10};
constexpr char too_large[] = "too many points";

const recording::Cloud& cloud_of(const AheadFrame& ahead) {
  return std::get<recording::Cloud>(ahead.frame.content);
}

std::span<float> points_of(AheadFrame& ahead) {
  return std::get<recording::Cloud>(ahead.frame.content).xyz;
}

Frame frame_of(const recording::FrameHeader& h) {
  Frame frame;
  frame.width = h.width;
  frame.height = h.height;
  frame.intrinsics = {h.fx, h.fy, h.cx, h.cy};
  frame.capture_time_ns = h.capture_time_ns;
  frame.device_time_us = h.device_time_us;
  return frame;
}

}  // namespace

McapSource::McapSource(const std::filesystem::path& path, bool loop, std::string topic,
                       recording::GapLimit gaps, std::optional<recording::Unit> unit,
                       std::uint64_t max_points)
    : path_(std::filesystem::absolute(path)),
      topic_(std::move(topic)),
      loop_(loop),
      gaps_(gaps),
      unit_(unit),
      max_points_(max_points) {}

Failure McapSource::open() {
  held_.reset();
  next_.reset();
  ended_ = false;
  said_jump_ = false;
  try {
    auto input = recording::open_frames({path_, topic_}, {recording::Kind::cloud});
    for (const std::string& remark : input->remarks()) {
      spdlog::warn("{}: {}", path_.string(), remark);
    }
    note_losses();
    reader_ = std::make_unique<ReadAhead>(std::move(input), loop_);
    AheadFrame first;
    if (read(first_frame_patience, first) == ReadAhead::Result::item) {
      sensor_ = first.frame.header().sensor;
      if (!unit_) recording::make_metres(points_of(first), unit_, path_.string());
      next_ = std::move(first);
      return std::nullopt;
    }
  } catch (const recording::WrongUnit& error) {
    return error.what();
  } catch (const recording::FileError& error) {
    return error.what();
  }
  note_problems();
  const std::string lost = text_of(counts().unusable);
  return path_.string() + ": holds no cloud that can be played" +
         (lost.empty() ? "" : ": " + lost) + "; `cleave info` says what it holds";
}

// The next frame of the sensor that the stream can carry.
ReadAhead::Result McapSource::read(std::chrono::milliseconds timeout, AheadFrame& ahead) {
  while (true) {
    const ReadAhead::Result result = reader_->next(timeout, ahead);
    if (result != ReadAhead::Result::item) return result;
    const recording::FrameHeader& header = ahead.frame.header();
    if (!sensor_.empty() && header.sensor != sensor_) continue;
    if (header.points() <= max_points_) return result;
    if (++unusable_[too_large] > 1) continue;
    spdlog::warn(
        "{}: skipped: {} x {} points, more than the {} that the stream can take; a larger "
        "--decimate makes fewer of them",
        path_.string(), header.width, header.height, max_points_);
  }
}

// The frame that is handed out is the one after the one before: the next one must be there, too, to
// tell when it is due.
Poll McapSource::next(std::chrono::milliseconds timeout, Frame& frame) {
  AheadFrame after;
  if (next_ && !ended_) {
    ReadAhead::Result result{};
    try {
      result = read(timeout, after);
    } catch (const recording::FileError& error) {
      error_ = error.what();
      return Poll::lost;
    }
    if (result == ReadAhead::Result::timeout) return Poll::timeout;
    if (result == ReadAhead::Result::end) {
      ended_ = true;
      note_problems();
    }
  }
  if (!next_) return Poll::end;

  const std::optional<AheadFrame> before = std::exchange(held_, std::exchange(next_, std::nullopt));
  if (!ended_) next_ = std::move(after);
  frame = frame_of(cloud_of(*held_).header);
  frame.begins_epoch = before && (before->pass != held_->pass ||
                                  before->frame.header().epoch != held_->frame.header().epoch);
  if (next_ && next_->pass == held_->pass) frame.until_next = until_next();
  return Poll::frame;
}

std::chrono::nanoseconds McapSource::until_next() {
  const std::int64_t before_ns = held_->frame.log_time_ns;
  const std::int64_t after_ns = next_->frame.log_time_ns;
  const recording::GapLimit::Gap gap = gaps_.between(before_ns, after_ns);
  if (gap.is_jump && !std::exchange(said_jump_, true)) {
    spdlog::warn("{}: {}", path_.string(), gaps_.text_of_jump(before_ns, after_ns));
  }
  return gap.wait;
}

void McapSource::write_points(float* xyz) {
  const std::vector<float>& points = cloud_of(*held_).xyz;
  std::copy(points.begin(), points.end(), xyz);
  recording::scale_to_metres({xyz, points.size()}, unit_.value_or(recording::Unit::metre));
}

void McapSource::note_problems() {
  for (const std::string& problem : reader_->problems()) {
    spdlog::warn("{}: skipped: {}", path_.string(), problem);
  }
}

// Before another reader counts from 0.
void McapSource::note_losses() {
  if (reader_) unusable_ = counts().unusable;
}

SourceCounts McapSource::counts() const {
  SourceCounts counts;
  counts.unusable = unusable_;
  if (!reader_) return counts;
  for (const auto& [cause, count] : reader_->losses()) counts.unusable[cause] += count;
  return counts;
}

}  // namespace cleave::sensor
