// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <cstdint>
#include <string>

#include "c/cleave.h"
#include "c/errors.hpp"
#include "c/handles.hpp"
#include "c/new_sample.hpp"
#include "libcleave/sequence.hpp"

namespace cleave::c {
namespace {

// Lists and statuses travel over the public domain alone.
struct IsZeroCopy {
  bool operator()(const CloudSample& cloud) const { return cloud.zero_copy(); }
  bool operator()(const LabelSample& labels) const { return labels.zero_copy(); }
  bool operator()(const ListSample& /*list*/) const { return false; }
  bool operator()(const Sample<NodeStatus>& /*status*/) const { return false; }
};

// Throws Failure where the sample is of another kind.
template <class Kind>
const Kind& sample_as(const cleave_sample* handle, const char* kind) {
  const auto* const sample = std::get_if<Kind>(&given(handle, "sample").sample);
  if (sample == nullptr) throw Failure(CLEAVE_BAD_DATA, std::string("the sample is no ") + kind);
  return *sample;
}

// `there`: what a header's points need. A sample hands out none where it has no room for them.
void check_points(const FrameHeader& header, std::size_t there) {
  if (there == point_count(header)) return;
  throw Failure(CLEAVE_BAD_DATA, "the header announces " + std::to_string(header.width) + " x " +
                                     std::to_string(header.height) +
                                     " points, more than the sample has room for");
}

// layout.cpp holds that these are the same.
const cleave_header* as_header(const FrameHeader* header) {
  return reinterpret_cast<const cleave_header*>(header);
}
template <class Ours, class Sequence>
void hand_out(const Sequence& sequence, const Ours*& first, std::size_t& count) {
  first = reinterpret_cast<const Ours*>(sequence._buffer);
  count = sequence._length;
}

cleave_list list_of(const SegmentList& from) {
  cleave_list to{};
  to.header = as_header(&from.header);
  to.cloud_publication_time_ns = from.cloud_publication_time_ns;
  to.cloud_reception_time_ns = from.cloud_reception_time_ns;
  to.outcome = from.outcome;
  hand_out(from.segments, to.segments, to.segment_count);
  hand_out(from.borders, to.borders, to.border_count);
  to.queue_ms = from.queue_ms;
  to.segmentation_ms = from.segmentation_ms;
  return to;
}

cleave_status status_of(const NodeStatus& from) {
  cleave_status to{};
  to.node = from.node;
  to.version = from.version;
  to.contract = from.contract;
  to.sensor = from.sensor;
  to.process_id = from.process_id;
  to.state = from.state;
  to.transport = from.transport_in_force;
  to.transport_reason = from.transport_reason;
  to.frames_in = from.frames_in;
  to.frames_out = from.frames_out;
  to.frames_dropped = from.frames_dropped;
  to.frames_rejected = from.frames_rejected;
  to.frames_in_flight = from.frames_in_flight;
  to.frames_zero_copy = from.frames_zero_copy;
  to.interruptions = from.interruptions;
  hand_out(from.dropped_by_cause, to.dropped_by_cause, to.dropped_cause_count);
  hand_out(from.rejected_by_cause, to.rejected_by_cause, to.rejected_cause_count);
  to.rate_hz = from.rate_hz;
  to.latency_median_ms = from.latency_median_ms;
  to.latency_p90_ms = from.latency_p90_ms;
  to.latency_p99_ms = from.latency_p99_ms;
  to.cpu_time_s = from.cpu_time_s;
  to.last_error = from.last_error;
  return to;
}

}  // namespace
}  // namespace cleave::c

void cleave_release(cleave_sample* sample) {
  delete sample;
}

cleave_kind cleave_sample_kind(const cleave_sample* sample) {
  return sample != nullptr ? static_cast<cleave_kind>(sample->sample.index()) : CLEAVE_CLOUD;
}

int cleave_sample_zero_copy(const cleave_sample* sample) {
  return sample != nullptr && std::visit(cleave::c::IsZeroCopy{}, sample->sample) ? 1 : 0;
}

const cleave_header* cleave_sample_header(const cleave_sample* sample) {
  return sample != nullptr ? cleave::c::as_header(cleave::c::header_of(sample->sample)) : nullptr;
}

cleave_result cleave_sample_cloud(const cleave_sample* sample, const float** xyz, size_t* count) {
  return cleave::c::guarded([&] {
    const auto& cloud = cleave::c::sample_as<cleave::CloudSample>(sample, "cloud");
    const float*& first = cleave::c::given(xyz, "xyz");
    size_t& points = cleave::c::given(count, "count");
    const auto values = cloud.xyz();
    cleave::c::check_points(cloud.header(), values.size() / 3);
    first = values.data();
    points = values.size() / 3;
    return CLEAVE_OK;
  });
}

cleave_result cleave_sample_labels(const cleave_sample* sample, const uint16_t** labels,
                                   size_t* count, int64_t* cloud_publication_time_ns) {
  return cleave::c::guarded([&] {
    const auto& map = cleave::c::sample_as<cleave::LabelSample>(sample, "label map");
    const uint16_t*& first = cleave::c::given(labels, "labels");
    size_t& points = cleave::c::given(count, "count");
    const auto values = map.labels();
    cleave::c::check_points(map.header(), values.size());
    first = values.data();
    points = values.size();
    if (cloud_publication_time_ns != nullptr) {
      *cloud_publication_time_ns = map.cloud_publication_time_ns();
    }
    return CLEAVE_OK;
  });
}

cleave_result cleave_sample_list(const cleave_sample* sample, cleave_list* list) {
  return cleave::c::guarded([&] {
    const auto& from = cleave::c::sample_as<cleave::ListSample>(sample, "segment list");
    cleave::c::given(list, "list") = cleave::c::list_of(from.message());
    return CLEAVE_OK;
  });
}

cleave_result cleave_sample_status(const cleave_sample* sample, cleave_status* status) {
  return cleave::c::guarded([&] {
    using Status = cleave::Sample<cleave::NodeStatus>;
    const auto& from = cleave::c::sample_as<Status>(sample, "status");
    cleave::c::given(status, "status") = cleave::c::status_of(*from);
    return CLEAVE_OK;
  });
}
