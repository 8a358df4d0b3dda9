// SPDX-License-Identifier: BSD-3-Clause
// Nodes' statuses for people and for programs.
#pragma once

#include <string>
#include <vector>

#include "console/json.hpp"
#include "libcleave/status.hpp"

namespace cleave::client {

// A line a node, and below the table what does not fit in it: why the transport is what it is,
// frames dropped and rejected by cause, the last error.
[[nodiscard]] std::string node_table(const std::vector<NodeReport>& reports);

// Keys as in the contract's NodeStatus; and `transport`, the one in force, and latency_ms {median,
// p90, p99}, as `cleave watch` has them.
[[nodiscard]] Json json_of(const NodeReport& report);

}  // namespace cleave::client
