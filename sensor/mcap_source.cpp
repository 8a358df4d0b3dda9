#include "sensor/mcap_source.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <utility>

#include "recording/error.hpp"
#include "recording/units/suspected_unit.hpp"

namespace cleave::sensor {
namespace {

using recording::AheadFrame;
using recording::ReadAhead;

constexpr std::chrono::seconds first_frame_patience{10};

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

McapSource::McapSource(const std::filesystem::path& path, bool loop,
                       std::optional<recording::Unit> unit)
    : path_(std::filesystem::absolute(path)), loop_(loop), unit_(unit) {}

Failure McapSource::open() {
  held_.reset();
  next_.reset();
  ended_ = false;
  try {
    const recording::Selection clouds{{recording::Kind::cloud}, sensor_, 0, {}};
    reader_ = std::make_unique<ReadAhead>(path_, clouds, loop_);
    AheadFrame first;
    if (reader_->next(first_frame_patience, first) == ReadAhead::Result::frame) {
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
  return path_.string() + ": holds no cloud; `cleave info` says what it holds";
}

// The frame that is handed out is the one after the one before: the next one must be there, too, to
// tell when it is due.
Poll McapSource::next(std::chrono::milliseconds timeout, Frame& frame) {
  AheadFrame after;
  while (next_ && !ended_) {
    ReadAhead::Result result{};
    try {
      result = reader_->next(timeout, after);
    } catch (const recording::FileError& error) {
      error_ = error.what();
      return Poll::lost;
    }
    if (result == ReadAhead::Result::timeout) return Poll::timeout;
    if (result == ReadAhead::Result::end) {
      ended_ = true;
      note_problems();
    } else if (after.frame.header().sensor == sensor_) {
      break;
    }
  }
  if (!next_) return Poll::end;

  const std::optional<AheadFrame> before = std::exchange(held_, std::exchange(next_, std::nullopt));
  if (!ended_) next_ = std::move(after);
  frame = frame_of(cloud_of(*held_).header);
  frame.begins_epoch = before && (before->pass != held_->pass ||
                                  before->frame.header().epoch != held_->frame.header().epoch);
  if (next_ && next_->pass == held_->pass) {
    const std::int64_t gap_ns = next_->frame.log_time_ns - held_->frame.log_time_ns;
    frame.until_next = std::chrono::nanoseconds(std::max<std::int64_t>(gap_ns, 0));
  }
  return Poll::frame;
}

void McapSource::write_points(float* xyz) {
  const std::vector<float>& points = cloud_of(*held_).xyz;
  std::copy(points.begin(), points.end(), xyz);
  recording::scale_to_metres({xyz, points.size()}, unit_.value_or(recording::Unit::metre));
}

void McapSource::note_problems() {
  for (const std::string& problem : reader_->problems()) {
    spdlog::warn("{}: damaged: {}", path_.string(), problem);
    ++damaged_;
  }
}

SourceCounts McapSource::counts() const {
  SourceCounts counts;
  if (damaged_ > 0) counts.unusable["damaged"] = damaged_;
  return counts;
}

}  // namespace cleave::sensor
