// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/stream/contract_frames.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "idl/copy_fields.hpp"
#include "idl/fields.hpp"
#include "libcleave/sequence.hpp"
#include "recording/error.hpp"

namespace cleave::client {
namespace {

// A copy of the header, and of as many values as it says.
template <class Value>
std::vector<Value> checked(const recording::FrameHeader& header, std::span<const Value> room,
                           std::size_t values_a_point) {
  const std::uint64_t points = header.points();
  if (points == 0 || points > room.size() / values_a_point) {
    throw recording::DataError("a frame of " + std::to_string(header.width) + " x " +
                               std::to_string(header.height) + " points");
  }
  const auto values = room.first(static_cast<std::size_t>(points) * values_a_point);
  return {values.begin(), values.end()};
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

recording::Cloud frame_of(const CloudSample& cloud) {
  recording::FrameHeader header = frame_of(cloud.header());
  std::vector<float> xyz = checked(header, cloud.room(), 3);
  return {std::move(header), std::move(xyz)};
}

recording::Labels frame_of(const LabelSample& labels) {
  recording::FrameHeader header = frame_of(labels.header());
  std::vector<std::uint16_t> label = checked(header, labels.room(), 1);
  return {std::move(header), labels.cloud_publication_time_ns(), std::move(label)};
}

recording::SegmentList frame_of(const SegmentList& message) {
  recording::SegmentList list;
  fields::segment_list(FromStream{}, message, list);
  return list;
}

void fill(FrameHeader& message, const recording::FrameHeader& header) {
  fields::header(ToStream{}, header, message);
}

void fill(const CloudLoan& message, const recording::Cloud& cloud) {
  fill(message.header(), cloud.header);
  std::ranges::copy(cloud.xyz, message.room().begin());
}

void fill(const LabelLoan& message, const recording::Labels& labels) {
  fill(message.header(), labels.header);
  message.cloud_publication_time_ns() = labels.cloud_publication_time_ns;
  std::ranges::copy(labels.label, message.room().begin());
}

SegmentListMessage::SegmentListMessage(const recording::SegmentList& list)
    : segments_(messages_of<SegmentMessage>(list.segments, fields::segment)),
      borders_(messages_of<BorderMessage>(list.borders, fields::border)) {
  fields::segment_list(ToStream{}, list, message_);
  lend(message_.segments, segments_);
  lend(message_.borders, borders_);
}

}  // namespace cleave::client
