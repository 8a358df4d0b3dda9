// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/stream/contract_frames.hpp"

#include <algorithm>
#include <string>

#include "idl/copy_fields.hpp"
#include "idl/fields.hpp"
#include "libcleave/sequence.hpp"
#include "recording/error.hpp"

namespace cleave::client {
namespace {

std::size_t checked_points(const FrameHeader& header) {
  const std::uint64_t points = point_count(header);
  if (points == 0 || points > capacity_points) {
    throw recording::DataError("a frame of " + std::to_string(header.width) + " x " +
                               std::to_string(header.height) + " points");
  }
  return static_cast<std::size_t>(points);
}

struct FromStream : fields::Copy<FromStream> {
  void text(const char* /*name*/, const char (&from)[64], std::string& to) { to = name_of(from); }
  template <class List, class From, class To>
  void each(const char* /*name*/, const List& list, const From& from, std::vector<To>& to) {
    to.clear();
    for (const auto& element : elements_of(from)) list(*this, element, to.emplace_back());
  }
};

// Sequences are for their owner to fill.
struct ToStream : fields::Copy<ToStream> {
  void text(const char* name, const std::string& from, char (&to)[64]) {
    if (set_name(to, from)) return;
    throw recording::DataError("a frame's " + std::string(name) + " has more than 63 characters");
  }
  template <class List, class From, class To>
  void each(const char* /*name*/, const List& /*list*/, const From& /*from*/, To& /*to*/) {}
};

template <class To, class From, class List>
std::vector<To> messages_of(const std::vector<From>& parts, const List& list) {
  std::vector<To> messages(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) list(ToStream{}, parts[i], messages[i]);
  return messages;
}

}  // namespace

recording::FrameHeader frame_of(const FrameHeader& message) {
  recording::FrameHeader header;
  fields::header(FromStream{}, message, header);
  return header;
}

recording::Cloud frame_of(const DepthCloud& cloud) {
  const float* const xyz = static_cast<const float*>(cloud.xyz);
  return {frame_of(cloud.header), {xyz, xyz + 3 * checked_points(cloud.header)}};
}

recording::Labels frame_of(const LabelMap& labels) {
  const std::uint16_t* const label = static_cast<const std::uint16_t*>(labels.label);
  return {frame_of(labels.header),
          labels.cloud_publication_time_ns,
          {label, label + checked_points(labels.header)}};
}

recording::SegmentList frame_of(const SegmentList& message) {
  recording::SegmentList list;
  fields::segment_list(FromStream{}, message, list);
  return list;
}

void fill(FrameHeader& message, const recording::FrameHeader& header) {
  fields::header(ToStream{}, header, message);
}

void fill(DepthCloud& message, const recording::Cloud& cloud) {
  fill(message.header, cloud.header);
  std::copy(cloud.xyz.begin(), cloud.xyz.end(), static_cast<float*>(message.xyz));
}

void fill(LabelMap& message, const recording::Labels& labels) {
  fill(message.header, labels.header);
  message.cloud_publication_time_ns = labels.cloud_publication_time_ns;
  std::copy(labels.label.begin(), labels.label.end(), static_cast<std::uint16_t*>(message.label));
}

SegmentListMessage::SegmentListMessage(const recording::SegmentList& list)
    : segments_(messages_of<SegmentMessage>(list.segments, fields::segment)),
      borders_(messages_of<BorderMessage>(list.borders, fields::border)) {
  fields::segment_list(ToStream{}, list, message_);
  lend(message_.segments, segments_);
  lend(message_.borders, borders_);
}

}  // namespace cleave::client
