// SPDX-License-Identifier: BSD-3-Clause
// The golden files through cleave_decode() and cleave_encode().
#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "c/cleave.h"
#include "idl/fields.hpp"
#include "tests/unit/golden/damage.hpp"
#include "tests/unit/golden/idl_json.hpp"

namespace cleave::test {
namespace {

struct ReleaseGolden {
  void operator()(cleave_sample* sample) const { cleave_release(sample); }
};
using GoldenHandle = std::unique_ptr<cleave_sample, ReleaseGolden>;

struct GoldenKind {
  const char* type;
  cleave_kind kind;
  int large;
};
constexpr GoldenKind golden_kinds[] = {
    {"DepthCloud", CLEAVE_CLOUD, 0},     {"LargeDepthCloud", CLEAVE_CLOUD, 1},
    {"LabelMap", CLEAVE_LABELS, 0},      {"LargeLabelMap", CLEAVE_LABELS, 1},
    {"SegmentList", CLEAVE_SEGMENTS, 0}, {"NodeStatus", CLEAVE_STATUS, 0}};

// Null where the bytes were refused.
GoldenHandle golden_decoded(const GoldenKind& kind, std::span<const std::byte> bytes) {
  cleave_sample* sample = nullptr;
  const cleave_result result =
      cleave_decode(kind.kind, kind.large, bytes.data(), bytes.size(), &sample);
  EXPECT_EQ(result == CLEAVE_OK, sample != nullptr);
  EXPECT_TRUE(result == CLEAVE_OK || result == CLEAVE_BAD_DATA) << cleave_error();
  return GoldenHandle(sample);
}

bool encodes_to(cleave_sample* sample, const std::vector<std::byte>& expected) {
  const void* bytes = nullptr;
  std::size_t size = 0;
  return cleave_encode(sample, &bytes, &size) == CLEAVE_OK && size == expected.size() &&
         std::memcmp(bytes, expected.data(), size) == 0;
}

template <class List, class Struct>
nlohmann::json json_in_c(const List& list, const Struct& value) {
  IdlJson fields;
  list(fields, value);
  return std::move(fields.json);
}

nlohmann::json causes_json(const cleave_cause* causes, std::size_t count) {
  nlohmann::json json = nlohmann::json::array();
  for (const auto& cause : std::span(causes, count)) {
    json.push_back(json_in_c(fields::cause_count, cause));
  }
  return json;
}

void expect_list(const cleave_sample* sample, const nlohmann::json& golden) {
  cleave_list list;
  ASSERT_EQ(cleave_sample_list(sample, &list), CLEAVE_OK) << cleave_error();
  EXPECT_EQ(json_of(list.cloud_reception_time_ns), golden["cloud_reception_time_ns"]);
  EXPECT_EQ(enumerator("FrameOutcome", list.outcome), golden["outcome"]);
  ASSERT_EQ(list.segment_count, golden["segments"].size());
  for (std::size_t i = 0; i < list.segment_count; ++i) {
    EXPECT_EQ(json_in_c(fields::segment, list.segments[i]), golden["segments"][i]);
  }
  ASSERT_EQ(list.border_count, golden["borders"].size());
  for (std::size_t i = 0; i < list.border_count; ++i) {
    const nlohmann::json border = {{"first", list.borders[i].first},
                                   {"second", list.borders[i].second},
                                   {"kind", enumerator("BorderKind", list.borders[i].kind)}};
    EXPECT_EQ(border, golden["borders"][i]);
  }
  EXPECT_EQ(json_of(list.segmentation_ms), golden["segmentation_ms"]);
}

void expect_status(const cleave_sample* sample, const nlohmann::json& golden) {
  cleave_status status;
  ASSERT_EQ(cleave_sample_status(sample, &status), CLEAVE_OK) << cleave_error();
  EXPECT_EQ(status.node, golden["node"]);
  EXPECT_EQ(status.contract, golden["contract"]);
  EXPECT_EQ(enumerator("NodeState", status.state), golden["state"]);
  EXPECT_EQ(enumerator("Transport", status.transport), golden["transport_in_force"]);
  EXPECT_EQ(json_of(status.frames_zero_copy), golden["frames_zero_copy"]);
  EXPECT_EQ(causes_json(status.dropped_by_cause, status.dropped_cause_count),
            golden["dropped_by_cause"]);
  EXPECT_EQ(causes_json(status.rejected_by_cause, status.rejected_cause_count),
            golden["rejected_by_cause"]);
  EXPECT_EQ(json_of(status.latency_p99_ms), golden["latency_p99_ms"]);
  EXPECT_EQ(json_of(status.cpu_time_s), golden["cpu_time_s"]);
  EXPECT_EQ(status.last_error, golden["last_error"]);
}

TEST(GoldenFilesInC, AreReadAndWritten) {
  for (const GoldenKind& kind : golden_kinds) {
    for (const GoldenSample& golden : golden_samples(kind.type)) {
      for (const auto* const bytes : {&golden.little_endian, &golden.big_endian}) {
        SCOPED_TRACE(golden.name);
        const GoldenHandle sample = golden_decoded(kind, *bytes);
        ASSERT_TRUE(sample) << cleave_error();
        EXPECT_TRUE(encodes_to(sample.get(), golden.little_endian));
        if (const cleave_header* const header = cleave_sample_header(sample.get())) {
          EXPECT_EQ(json_in_c(fields::header, *header), golden.json["header"]);
        }
        if (kind.kind == CLEAVE_SEGMENTS) expect_list(sample.get(), golden.json);
        if (kind.kind == CLEAVE_STATUS) expect_status(sample.get(), golden.json);
      }
    }
  }
}

TEST(GoldenFilesInC, ThatAreDamagedAreReadOrRefused) {
  for (const GoldenKind& kind : golden_kinds) {
    const bool bulk = kind.kind == CLEAVE_CLOUD || kind.kind == CLEAVE_LABELS;
    damage(kind.type, bulk ? bulk_header : whole_file, [&](std::span<const std::byte> bytes) {
      const GoldenHandle sample = golden_decoded(kind, bytes);
      const void* again = nullptr;
      std::size_t size = 0;
      EXPECT_TRUE(!sample || cleave_encode(sample.get(), &again, &size) == CLEAVE_OK);
      return sample != nullptr;
    });
  }
}

}  // namespace
}  // namespace cleave::test
