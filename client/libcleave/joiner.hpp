// SPDX-License-Identifier: BSD-3-Clause
// Pairs every cloud with the label map of the same epoch and frame id, both still where the
// transport put them.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "libcleave/cloud_reader.hpp"
#include "libcleave/types.hpp"

namespace cleave {

struct JoinedFrame {
  CloudSample cloud;
  LabelSample labels;
};

class Joiner {
 public:
  // At most `capacity` unpaired clouds and label maps wait each (they keep their chunks out of the
  // pool); beyond that the oldest is given up and counted.
  explicit Joiner(std::size_t capacity = 4) : capacity_(capacity) {}

  // The frame that this sample completes, if any. Samples older than it that are still unpaired are
  // given up: frames come in order, so their partner was lost.
  [[nodiscard]] std::optional<JoinedFrame> add(CloudSample cloud);
  [[nodiscard]] std::optional<JoinedFrame> add(LabelSample labels);

  // Samples given up without a partner.
  [[nodiscard]] std::uint64_t unpaired() const { return unpaired_; }

 private:
  std::size_t capacity_;
  std::deque<CloudSample> clouds_;
  std::deque<LabelSample> labels_;
  std::uint64_t unpaired_ = 0;
};

}  // namespace cleave
