// SPDX-License-Identifier: BSD-3-Clause
// Who publishes and reads what on this machine: DDS's own built-in topics.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "libcleave/internal/topic.hpp"
#include "libcleave/stream.hpp"

namespace cleave {

struct Endpoint {
  Domain domain;
  bool writes;  // else reads
  std::string topic;
  std::string type;
  std::string process;  // name and id, where the vendor tells; else empty
};

// All endpoints of cleave/... topics, this process's own excluded, sorted by topic, writers first.
// Discovery takes a moment: listens for `listen` first.
[[nodiscard]] std::vector<Endpoint> discover(Stream& stream, std::chrono::milliseconds listen);

// The first of the endpoints that publishes a type of another version of the contract, in words;
// such nodes and this one do not hear each other. Empty if there is none.
[[nodiscard]] std::string other_contract(const std::vector<Endpoint>& endpoints);

}  // namespace cleave
