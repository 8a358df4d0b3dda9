// SPDX-License-Identifier: BSD-3-Clause
// The golden files through Cyclone's serialisation, and through that of recordings.
#include <gtest/gtest.h>

#include <algorithm>

#include "idl/fields.hpp"
#include "libcleave/cdr.hpp"
#include "libcleave/reader.hpp"
#include "recording/frames/segment_list_message.hpp"
#include "tests/unit/golden/golden_files.hpp"
#include "tests/unit/golden/idl_json.hpp"

namespace cleave::test {
namespace {

// The values that the golden file gives; behind them all must be 0.
template <class Value>
nlohmann::json first_values(std::span<const Value> values, std::size_t count) {
  nlohmann::json json = nlohmann::json::array();
  for (const Value value : values.first(count)) json.push_back(json_of(value));
  EXPECT_TRUE(
      std::ranges::all_of(values.subspan(count), [](Value value) { return value == Value{}; }));
  return json;
}

template <class List, class Struct>
nlohmann::json fields_json(const List& list, const Struct& value) {
  IdlJson fields;
  list(fields, value);
  return std::move(fields.json);
}

// `golden` says how many values of a bulk type to show.
template <class Cloud>
nlohmann::json sample_json(const Cloud& cloud, const nlohmann::json& golden) requires requires {
  cloud.xyz;
}
{
  return {{"header", fields_json(fields::header, cloud.header)},
          {"xyz", first_values(std::span<const float>(cloud.xyz), golden.at("xyz").size())}};
}
template <class Labels>
nlohmann::json sample_json(const Labels& labels, const nlohmann::json& golden) requires requires {
  labels.label;
}
{
  const std::span<const std::uint16_t> values(labels.label);
  return {{"header", fields_json(fields::header, labels.header)},
          {"cloud_publication_time_ns", json_of(labels.cloud_publication_time_ns)},
          {"label", first_values(values, golden.at("label").size())}};
}
nlohmann::json sample_json(const SegmentList& list, const nlohmann::json& /*golden*/) {
  return fields_json(fields::segment_list, list);
}
nlohmann::json sample_json(const NodeStatus& status, const nlohmann::json& /*golden*/) {
  return fields_json(fields::node_status, status);
}

// Both byte orders are the JSON, and are written again as the little-endian file.
template <class T>
void expect_golden(const std::string& type) {
  for (const GoldenSample& golden : golden_samples(type)) {
    for (const auto* const bytes : {&golden.little_endian, &golden.big_endian}) {
      const Sample<T> sample(sample_of_cdr<T>(*bytes));
      EXPECT_EQ(sample_json(*sample, golden.json), golden.json) << golden.name;
      EXPECT_TRUE(cdr_of(*sample) == golden.little_endian) << golden.name;  // too long to print
    }
  }
}

TEST(GoldenFiles, OfCloudsAreReadAndWrittenByCyclone) {
  expect_golden<DepthCloud>("DepthCloud");
  expect_golden<LargeDepthCloud>("LargeDepthCloud");
}

TEST(GoldenFiles, OfLabelMapsAreReadAndWrittenByCyclone) {
  expect_golden<LabelMap>("LabelMap");
  expect_golden<LargeLabelMap>("LargeLabelMap");
}

TEST(GoldenFiles, OfSegmentListsAreReadAndWrittenByCyclone) {
  expect_golden<SegmentList>("SegmentList");
}

TEST(GoldenFiles, OfStatusesAreReadAndWrittenByCyclone) {
  expect_golden<NodeStatus>("NodeStatus");
}

TEST(GoldenFiles, OfSegmentListsAreReadAndWrittenByRecordings) {
  for (const GoldenSample& golden : golden_samples("SegmentList")) {
    for (const auto* const bytes : {&golden.little_endian, &golden.big_endian}) {
      const recording::SegmentList list = recording::read_segment_list(*bytes);
      EXPECT_EQ(fields_json(fields::segment_list, list), golden.json) << golden.name;
      EXPECT_EQ(recording::segment_list_message(list), golden.little_endian) << golden.name;
    }
  }
}

}  // namespace
}  // namespace cleave::test
