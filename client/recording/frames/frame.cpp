// SPDX-License-Identifier: BSD-3-Clause
#include "recording/frames/frame.hpp"

#include "idl/outcome_name.hpp"

namespace cleave::recording {

const char* name_of(BorderKind kind) {
  return kind == BorderKind::convex ? "convex" : "concave";
}

const char* name_of(FrameOutcome outcome) {
  return outcome_name(static_cast<std::uint32_t>(outcome));
}

}  // namespace cleave::recording
