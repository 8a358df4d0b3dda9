// SPDX-License-Identifier: BSD-3-Clause
// The golden files, damaged a thousand times each: a valid sample or an error, never a crash. The
// sanitizers see what else may happen.
#include <gtest/gtest.h>

#include <span>

#include "libcleave/cdr.hpp"
#include "libcleave/reader.hpp"
#include "recording/error.hpp"
#include "recording/frames/segment_list_message.hpp"
#include "tests/unit/golden/damage.hpp"

namespace cleave::test {
namespace {

// What is read can be written again.
template <class T>
bool read_by_cyclone(std::span<const std::byte> bytes) {
  try {
    const Sample<T> sample(sample_of_cdr<T>(bytes));
    return !cdr_of(*sample).empty();
  } catch (const CdrError&) {
    return false;
  }
}

bool read_by_recordings(std::span<const std::byte> bytes) {
  try {
    const recording::SegmentList list = recording::read_segment_list(bytes);
    return !recording::segment_list_message(list).empty();
  } catch (const recording::DataError&) {
    return false;
  }
}

TEST(DamagedGoldenFiles, OfSegmentListsAreReadOrRefused) {
  damage("SegmentList", whole_file, read_by_cyclone<SegmentList>);
}

TEST(DamagedGoldenFiles, OfSegmentListsAreReadOrRefusedByRecordings) {
  damage("SegmentList", whole_file, read_by_recordings);
}

TEST(DamagedGoldenFiles, OfStatusesAreReadOrRefused) {
  damage("NodeStatus", whole_file, read_by_cyclone<NodeStatus>);
}

TEST(DamagedGoldenFiles, OfCloudsAreReadOrRefused) {
  damage("DepthCloud", bulk_header, read_by_cyclone<DepthCloud>);
  damage("LargeDepthCloud", bulk_header, read_by_cyclone<LargeDepthCloud>);
}

TEST(DamagedGoldenFiles, OfLabelMapsAreReadOrRefused) {
  damage("LabelMap", bulk_header, read_by_cyclone<LabelMap>);
  damage("LargeLabelMap", bulk_header, read_by_cyclone<LargeLabelMap>);
}

}  // namespace
}  // namespace cleave::test
