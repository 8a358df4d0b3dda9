// SPDX-License-Identifier: BSD-3-Clause
// What to say where no node is seen.
#pragma once

#include <string>

#include "libcleave/stream.hpp"

namespace cleave::client {

// Why that may be, and what to do about it. Listens for nodes of another contract.
[[nodiscard]] std::string nobody_answers(Stream& stream);

}  // namespace cleave::client
