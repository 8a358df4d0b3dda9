// SPDX-License-Identifier: BSD-3-Clause
// Joins clouds, label maps and segment lists of the same frame, in whichever order they come: the
// lists travel on another domain than the other two.
#pragma once

#include <cstdint>
#include <optional>

#include "idl/frame_key.hpp"
#include "libcleave/frames/joiner.hpp"
#include "libcleave/internal/waiting.hpp"
#include "libcleave/list_reader.hpp"

namespace cleave {

struct CompleteFrame {
  CloudSample cloud;
  LabelSample labels;
  ListSample list;
};

class FrameJoiner {
 public:
  // The frame that this sample completes, if any; what is older than it is given up, as by Joiner.
  [[nodiscard]] std::optional<CompleteFrame> add(CloudSample cloud);
  [[nodiscard]] std::optional<CompleteFrame> add(LabelSample labels);
  [[nodiscard]] std::optional<CompleteFrame> add(ListSample list);

  // Samples given up because the rest of their frame did not come. (A rejected frame has no label
  // map, so its cloud and its list are among them.)
  [[nodiscard]] std::uint64_t given_up() const {
    return joiner_.unpaired() + 2 * pairs_.given_up() + lists_.given_up();
  }

 private:
  struct PairKey {
    FrameKey operator()(const JoinedFrame& pair) const { return key_of(pair.cloud.header()); }
  };
  struct ListKey {
    FrameKey operator()(const ListSample& list) const { return key_of(list.header()); }
  };
  [[nodiscard]] std::optional<CompleteFrame> add_pair(std::optional<JoinedFrame> pair);

  Joiner joiner_;
  // A pair keeps two chunks out of the pool, a list none. A list comes a moment after its pair.
  Waiting<JoinedFrame, PairKey> pairs_{2};
  Waiting<ListSample, ListKey> lists_{8};
};

}  // namespace cleave
