// SPDX-License-Identifier: BSD-3-Clause
// Clouds and label maps onto the stream: loaned, filled in place and published without a copy.
#pragma once

#include <cstdint>

#include "libcleave/internal/bulk_writer.hpp"

namespace cleave {

// Memory for a cloud: fill its header and room().
using CloudLoan = BulkLoan<CloudKind>;

// Memory for a label map: fill its header, the time of its cloud, and room().
class LabelLoan : public BulkLoan<LabelKind> {
 public:
  using BulkLoan::BulkLoan;
  [[nodiscard]] std::int64_t& cloud_publication_time_ns() const {
    return static_cast<LabelMap*>(memory())->cloud_publication_time_ns;
  }
};

using CloudWriter = BulkWriter<CloudKind, CloudLoan>;
using LabelWriter = BulkWriter<LabelKind, LabelLoan>;

}  // namespace cleave
