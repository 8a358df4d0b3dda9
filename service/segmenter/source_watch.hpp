// SPDX-License-Identifier: BSD-3-Clause
// Whether someone publishes clouds for a sensor, in terms of the node's state.
#pragma once

#include "libcleave/status.hpp"

namespace cleave::service {

class SourceWatch {
 public:
  // `writers` of the cloud topic are alive now. True if that changed the state.
  bool update(unsigned writers) {
    const NodeState before = state_;
    if (writers > 0) {
      state_ = NodeState::running;
    } else if (state_ == NodeState::running) {
      state_ = NodeState::source_lost;
    }
    return state_ != before;
  }

  // starting: none so far; running; source_lost: there was one.
  [[nodiscard]] NodeState state() const { return state_; }

 private:
  NodeState state_ = NodeState::starting;
};

}  // namespace cleave::service
