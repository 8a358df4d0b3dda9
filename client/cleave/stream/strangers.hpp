// SPDX-License-Identifier: BSD-3-Clause
// Who puts something on the bus that does not belong to what the nodes say of themselves.
#pragma once

#include <string>
#include <vector>

#include "libcleave/discovery.hpp"
#include "libcleave/status.hpp"

namespace cleave::client {

// A line each: several programs that publish one topic of a sensor, one that publishes segment
// lists and is not the segmenter of the sensor's status, one of another version of the contract.
// Programs are named where their DDS tells who they are.
[[nodiscard]] std::vector<std::string> strangers(const std::vector<Endpoint>& endpoints,
                                                 const std::vector<NodeReport>& nodes);

}  // namespace cleave::client
