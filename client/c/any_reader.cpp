// SPDX-License-Identifier: BSD-3-Clause
#include "c/any_reader.hpp"

#include <algorithm>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace cleave::c {
namespace {

constexpr std::uint32_t greatest_depth = 256;  // of a subscriber's queue in iceoryx

template <class OneReader>
ReaderOfKind open(Stream& stream, const std::string& sensor, std::uint32_t depth) {
  constexpr std::in_place_type_t<OneReader> type;
  if (depth == 0) return ReaderOfKind(type, stream, sensor);
  return ReaderOfKind(type, stream, sensor, ReaderDepth{static_cast<int>(depth)});
}

ReaderOfKind open(Stream& stream, std::uint32_t kind, const std::string& sensor,
                  std::uint32_t depth) {
  if (depth > greatest_depth) {
    throw std::invalid_argument("a depth of " + std::to_string(depth) + " is more than " +
                                std::to_string(greatest_depth));
  }
  if (kind != CLEAVE_STATUS && !is_valid_sensor_name(sensor)) {
    throw std::invalid_argument("a sensor's name is of 1 to 63 letters, digits or '_', not '" +
                                sensor + "'");
  }
  switch (kind) {
    case CLEAVE_CLOUD:
      return open<CloudReader>(stream, sensor, depth);
    case CLEAVE_LABELS:
      return open<LabelReader>(stream, sensor, depth);
    case CLEAVE_SEGMENTS:
      return open<ListReader>(stream, sensor, depth);
    case CLEAVE_STATUS:
      return open<Reader<NodeStatus>>(stream, sensor, depth);
    default:
      throw std::invalid_argument(std::to_string(kind) + " is no cleave_kind");
  }
}

}  // namespace

AnyReader::AnyReader(std::shared_ptr<Stream> stream, std::uint32_t kind, const std::string& sensor,
                     std::uint32_t depth)
    : stream_(std::move(stream)), reader_(open(*stream_, kind, sensor, depth)) {
  std::visit([this](const auto& reader) { ready_.attach(reader); }, reader_);
}

std::optional<AnySample> AnyReader::take_from_dds() {
  return std::visit(
      [](auto& reader) -> std::optional<AnySample> {
        if (auto sample = reader.take()) return AnySample(std::move(*sample));
        return std::nullopt;
      },
      reader_);
}

std::optional<AnySample> AnyReader::take() {
  if (next_) return std::exchange(next_, std::nullopt);
  return ready_.take([this] { return take_from_dds(); });
}

bool AnyReader::wait(std::chrono::milliseconds timeout) {
  using Clock = std::chrono::steady_clock;
  using std::chrono::milliseconds;
  const Clock::time_point start = Clock::now();
  for (;;) {
    if (!next_) next_ = ready_.take([this] { return take_from_dds(); });
    if (next_) return true;
    const auto waited = std::chrono::duration_cast<milliseconds>(Clock::now() - start);
    if (timeout.count() >= 0 && waited > timeout) return false;
    if (!ready_.wait(timeout.count() < 0 ? timeout : timeout - waited)) return false;
  }
}

unsigned AnyReader::live_writers() const {
  return std::visit([](const auto& reader) { return reader.live_writers(); }, reader_);
}

}  // namespace cleave::c
