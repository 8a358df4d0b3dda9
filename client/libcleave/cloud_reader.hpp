// SPDX-License-Identifier: BSD-3-Clause
// Clouds and label maps as they come, small or large. A sample that came over shared memory is
// handed out in place: it is never copied.
#pragma once

#include <cstdint>
#include <span>

#include "libcleave/internal/bulk_reader.hpp"

namespace cleave {

// A cloud, in place.
class CloudSample : public BulkSample<CloudKind> {
 public:
  using BulkSample::BulkSample;
  // x, y, z of each point in metres, row-major, in the header's coordinate frame; NaN = no
  // measurement. Empty where the header announces more points than the type has room for.
  [[nodiscard]] std::span<const float> xyz() const { return values(); }
};

// A label map, in place.
class LabelSample : public BulkSample<LabelKind> {
 public:
  using BulkSample::BulkSample;
  // One label a point; 0 = no segment. Empty as a cloud's points are.
  [[nodiscard]] std::span<const std::uint16_t> labels() const { return values(); }
  // When the cloud that it labels was published: CLOCK_MONOTONIC.
  [[nodiscard]] std::int64_t cloud_publication_time_ns() const {
    return static_cast<const LabelMap*>(data())->cloud_publication_time_ns;
  }
};

using CloudReader = BulkReader<CloudKind, CloudSample>;
using LabelReader = BulkReader<LabelKind, LabelSample>;

}  // namespace cleave
