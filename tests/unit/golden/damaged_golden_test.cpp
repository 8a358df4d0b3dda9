// SPDX-License-Identifier: BSD-3-Clause
// The golden files, damaged a thousand times each: a valid sample or an error, never a crash. The
// sanitizers see what else may happen.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <random>

#include "libcleave/cdr.hpp"
#include "libcleave/reader.hpp"
#include "recording/error.hpp"
#include "recording/frames/segment_list_message.hpp"
#include "tests/unit/golden/golden_files.hpp"

namespace cleave::test {
namespace {

using CdrBytes = std::vector<std::byte>;
constexpr int mutations = 1000;

// Flips bits, or puts a number where a length may be, among the first `reach` bytes; and cuts off.
class Damage {
 public:
  explicit Damage(std::size_t reach) : reach_(reach) {}

  // The part of `bytes` that is left.
  std::span<const std::byte> apply(CdrBytes& bytes) {
    const std::size_t reach = std::min(reach_, bytes.size());
    // Of megabytes of numbers few are looked at whole, for the sake of time.
    const bool bulk = reach < bytes.size();
    switch (below(3)) {
      case 0:
        break;
      case 1:
        for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
          bytes[below(reach)] ^= static_cast<std::byte>(1U << below(8));
        }
        if (bulk && below(50) != 0) break;
        return bytes;
      default: {
        const std::array<std::uint32_t, 7> lies = {
            0, 1, 17, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF, static_cast<std::uint32_t>(bytes.size())};
        const std::uint32_t lie = lies.at(below(lies.size()));
        std::memcpy(&bytes[4 * below(reach / 4)], &lie, sizeof lie);
        if (bulk && below(50) != 0) break;
        return bytes;
      }
    }
    const bool at_the_end = below(bulk ? 50 : 2) == 0;
    return std::span(bytes).first(at_the_end ? bytes.size() - 1 - below(9) : below(reach));
  }

 private:
  std::size_t below(std::size_t limit) { return static_cast<std::size_t>(random_() % limit); }
  std::mt19937 random_{11};
  std::size_t reach_;
};

// How many of all mutations `read` takes; it returns false for what it refuses.
template <class Read>
void damage(const std::string& type, std::size_t reach, const Read& read) {
  for (const GoldenSample& golden : golden_samples(type)) {
    for (const CdrBytes& whole : {golden.little_endian, golden.big_endian}) {
      Damage damage(reach);
      CdrBytes bytes = whole;
      int taken = 0;
      for (int i = 0; i < mutations; ++i) {
        if (read(damage.apply(bytes))) ++taken;
        std::copy_n(whole.begin(), std::min(reach, whole.size()), bytes.begin());
      }
      EXPECT_GT(taken, 0) << golden.name;
      EXPECT_LT(taken, mutations) << golden.name;
    }
  }
}

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

constexpr std::size_t all = SIZE_MAX;
constexpr std::size_t header = 400;  // behind a bulk type's header are numbers alone

TEST(DamagedGoldenFiles, OfSegmentListsAreReadOrRefused) {
  damage("SegmentList", all, read_by_cyclone<SegmentList>);
}

TEST(DamagedGoldenFiles, OfSegmentListsAreReadOrRefusedByRecordings) {
  damage("SegmentList", all, read_by_recordings);
}

TEST(DamagedGoldenFiles, OfStatusesAreReadOrRefused) {
  damage("NodeStatus", all, read_by_cyclone<NodeStatus>);
}

TEST(DamagedGoldenFiles, OfCloudsAreReadOrRefused) {
  damage("DepthCloud", header, read_by_cyclone<DepthCloud>);
  damage("LargeDepthCloud", header, read_by_cyclone<LargeDepthCloud>);
}

TEST(DamagedGoldenFiles, OfLabelMapsAreReadOrRefused) {
  damage("LabelMap", header, read_by_cyclone<LabelMap>);
  damage("LargeLabelMap", header, read_by_cyclone<LargeLabelMap>);
}

}  // namespace
}  // namespace cleave::test
