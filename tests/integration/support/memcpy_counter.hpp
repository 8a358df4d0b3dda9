// SPDX-License-Identifier: BSD-3-Clause
// Counts the copies of 100 kB and more that anything in this process makes, DDS included.
#pragma once

#include <cstdint>

namespace cleave::test {

// Calls of memcpy and memmove with 100 kB or more since the program began.
std::uint64_t large_copies();

}  // namespace cleave::test
