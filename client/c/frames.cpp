// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "c/cleave.h"
#include "c/errors.hpp"
#include "c/handles.hpp"
#include "c/new_sample.hpp"

using cleave::c::AnySample;
using cleave::c::given;
using cleave::c::guarded;
using cleave::c::new_sample;

namespace {

const char* why_no_frame(const cleave::FrameReader& reader) {
  if (reader.live_sensors() == 0)
    return "no frame came in time: nobody publishes the sensor's clouds";
  if (reader.live_segmenters() == 0) {
    return "no frame came in time: clouds are published, but nobody segments them";
  }
  return "no frame was complete in time";
}

}  // namespace

cleave_result cleave_frames_open(cleave_stream* stream, const char* sensor,
                                 cleave_frames** frames) {
  return guarded([&] {
    const auto& shared = given(stream, "stream").stream;
    cleave_frames*& result = given(frames, "frames");
    if (!cleave::is_valid_sensor_name(&given(sensor, "sensor"))) {
      throw std::invalid_argument("a sensor's name is of 1 to 63 letters, digits or '_', not '" +
                                  std::string(sensor) + "'");
    }
    result = new cleave_frames{std::make_shared<cleave::c::Frames>(shared, sensor)};
    return CLEAVE_OK;
  });
}

void cleave_frames_close(cleave_frames* frames) {
  delete frames;
}

cleave_result cleave_frames_next(cleave_frames* frames, int32_t timeout_ms, cleave_sample** cloud,
                                 cleave_sample** labels, cleave_sample** segments) {
  return guarded([&] {
    auto& shared = given(frames, "frames").frames;
    (void)given(cloud, "cloud");
    (void)given(labels, "labels");
    (void)given(segments, "segments");
    auto frame = shared->reader.next(std::chrono::milliseconds(timeout_ms));
    if (!frame) return cleave::c::fail(CLEAVE_TIMEOUT, why_no_frame(shared->reader));
    auto first = new_sample(shared, AnySample(std::move(frame->cloud)));
    auto second = new_sample(shared, AnySample(std::move(frame->labels)));
    auto third = new_sample(shared, AnySample(std::move(frame->list)));
    *cloud = first.release();
    *labels = second.release();
    *segments = third.release();
    return CLEAVE_OK;
  });
}

int cleave_frames_fd(const cleave_frames* frames) {
  return frames != nullptr ? frames->frames->reader.descriptor() : -1;
}

uint64_t cleave_frames_given_up(const cleave_frames* frames) {
  return frames != nullptr ? frames->frames->reader.given_up() : 0;
}
