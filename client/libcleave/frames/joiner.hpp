// SPDX-License-Identifier: BSD-3-Clause
// Pairs every cloud with the label map of the same epoch and frame id, both still where the
// transport put them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "idl/frame_key.hpp"
#include "libcleave/cloud_reader.hpp"
#include "libcleave/internal/waiting.hpp"
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
  explicit Joiner(std::size_t capacity = 4) : clouds_(capacity), labels_(capacity) {}

  // The frame that this sample completes, if any. Samples older than it that are still unpaired are
  // given up: frames come in order, so their partner was lost.
  [[nodiscard]] std::optional<JoinedFrame> add(CloudSample cloud);
  [[nodiscard]] std::optional<JoinedFrame> add(LabelSample labels);

  // Samples given up without a partner.
  [[nodiscard]] std::uint64_t unpaired() const { return clouds_.given_up() + labels_.given_up(); }

 private:
  struct Key {
    template <class BulkSample>
    FrameKey operator()(const BulkSample& sample) const {
      return key_of(sample.header());
    }
  };
  Waiting<CloudSample, Key> clouds_;
  Waiting<LabelSample, Key> labels_;
};

}  // namespace cleave
