// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/verification/golden.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "idl/fields.hpp"

namespace cleave::workbench {
namespace {

using Lines = std::vector<std::string>;

constexpr double mm_per_m = 1000;
// Label maps and lists of a frame are recorded within so many frames of each other.
constexpr std::size_t frames_apart = 64;

void compare_labels(const recording::Labels& expected, const recording::Labels& found,
                    const Tolerances& tolerances, Lines& lines) {
  if (expected.header.width != found.header.width ||
      expected.header.height != found.header.height) {
    lines.push_back(fmt::format("label map: {} x {}, expected {} x {}", found.header.width,
                                found.header.height, expected.header.width,
                                expected.header.height));
    return;
  }
  std::size_t differ = 0;
  std::size_t first = 0;
  for (std::size_t i = expected.label.size(); i-- > 0;) {
    if (expected.label[i] == found.label[i]) continue;
    ++differ;
    first = i;
  }
  if (static_cast<double>(differ) <=
      tolerances.points_share * static_cast<double>(expected.label.size())) {
    return;
  }
  lines.push_back(
      fmt::format("labels: {} of {} points differ, the first at column {}, row {}: {}, "
                  "expected {}",
                  differ, expected.label.size(), first % expected.header.width,
                  first / expected.header.width, found.label[first], expected.label[first]));
}

double distance_m(const recording::Point& a, const recording::Point& b) {
  return std::hypot(double{a.x} - double{b.x}, double{a.y} - double{b.y},
                    double{a.z} - double{b.z});
}

// The names of the fields (idl/fields.hpp) in which two are not equal.
struct Differing {
  std::string names;

  template <class Value>
  void number(const char* name, const Value& a, const Value& b) {
    if (a != b) names.append(names.empty() ? "" : ", ").append(name);
  }
  template <class List, class Value>
  void group(const char* name, const List& /*list*/, const Value& a, const Value& b) {
    number(name, a, b);
  }
};

void compare_segment(const recording::Segment& expected, const recording::Segment& found,
                     std::uint64_t frame_points, const Tolerances& tolerances, Lines& lines) {
  const std::string name = fmt::format("segment {}: ", expected.label);
  const std::size_t before = lines.size();
  const double counts =
      std::fabs(static_cast<double>(found.point_count) - static_cast<double>(expected.point_count));
  if (counts > tolerances.points_share * static_cast<double>(frame_points)) {
    lines.push_back(
        fmt::format("{}{} points, expected {}", name, found.point_count, expected.point_count));
  }
  const auto compare_place = [&](const char* what, const recording::Point& a,
                                 const recording::Point& b) {
    const double off_m = distance_m(a, b);
    if (!(off_m <= tolerances.distance_m)) {
      lines.push_back(fmt::format("{}{} is off by {:.3g} mm", name, what, off_m * mm_per_m));
    }
  };
  compare_place("its centroid", found.centroid, expected.centroid);
  compare_place("its box's centre", found.box.centre, expected.box.centre);
  compare_place("its box's size", found.box.extent, expected.box.extent);
  if (!tolerances.exact() || lines.size() > before || expected == found) return;
  Differing differing;
  fields::segment(differing, expected, found);
  lines.push_back(fmt::format("{}not the same {}", name, differing.names));
}

void compare_lists(const recording::SegmentList& expected, const recording::SegmentList& found,
                   const Tolerances& tolerances, Lines& lines) {
  if (expected.outcome != found.outcome) {
    lines.push_back(
        fmt::format("outcome: {}, expected {}", name_of(found.outcome), name_of(expected.outcome)));
  }
  if (expected.segments.size() != found.segments.size()) {
    lines.push_back(
        fmt::format("{} segments, expected {}", found.segments.size(), expected.segments.size()));
    return;
  }
  for (std::size_t i = 0; i < expected.segments.size(); ++i) {
    compare_segment(expected.segments[i], found.segments[i], expected.header.points(), tolerances,
                    lines);
  }
  if (tolerances.exact() && expected.borders != found.borders) {
    lines.push_back(
        fmt::format("borders: {}, expected {}{}", found.borders.size(), expected.borders.size(),
                    found.borders.size() == expected.borders.size() ? ", and not the same" : ""));
  }
}

}  // namespace

Lines differences(const GoldenFrame& expected, const SegmentedCloud& found,
                  const Tolerances& tolerances) {
  Lines lines;
  if (expected.labels) compare_labels(*expected.labels, found.labels, tolerances, lines);
  if (expected.list) compare_lists(*expected.list, found.list, tolerances, lines);
  return lines;
}

GoldenFrames::GoldenFrames(const std::filesystem::path& file)
    : reader_(file, {{recording::Kind::labels, recording::Kind::segments}, "", 0, {}}) {}

GoldenFrames::Key GoldenFrames::place_of(const recording::FrameHeader& header) {
  return {header.sensor, key_of(header)};
}

// False at the end.
bool GoldenFrames::read_one() {
  auto frame = reader_.next();
  if (!frame) return false;
  GoldenFrame& golden = waiting_[place_of(frame->header())];
  if (frame->kind() == recording::Kind::labels) {
    golden.labels = std::get<recording::Labels>(std::move(frame->content));
  } else {
    golden.list = std::get<recording::SegmentList>(std::move(frame->content));
  }
  return true;
}

std::optional<GoldenFrame> GoldenFrames::take(const recording::FrameHeader& cloud) {
  const Key key = place_of(cloud);
  const auto is_whole = [&] {
    const auto found = waiting_.find(key);
    return found != waiting_.end() && found->second.labels && found->second.list;
  };
  while (!is_whole() && waiting_.size() < frames_apart && read_one()) {
  }
  auto node = waiting_.extract(key);
  if (node.empty()) return std::nullopt;
  return std::move(node.mapped());
}

std::size_t GoldenFrames::left() {
  std::set<Key> left;  // only the keys: the frames may be many
  do {
    for (const auto& [key, frame] : waiting_) left.insert(key);
    waiting_.clear();
  } while (read_one());
  return left.size();
}

}  // namespace cleave::workbench
