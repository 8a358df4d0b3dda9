// SPDX-License-Identifier: BSD-3-Clause
// Whom a DDS domain of this process hears.
#pragma once

#include <cstdint>
#include <string>

namespace cleave {

// Cyclone binds its sockets to 0.0.0.0: an interface in its configuration is where it sends, not
// where it listens. This puts a filter on the domain's sockets, so that the kernel drops what comes
// in by another interface than `interface` (name or address) and loopback. Call it when the
// domain's participant is there and has no readers yet: then nothing that came before is delivered.
// Throws std::runtime_error where that fails, for the domain would be open to the network.
void hear_only(const std::string& interface, std::uint32_t domain);

}  // namespace cleave
