// SPDX-License-Identifier: BSD-3-Clause
// How often this thread asks for memory: by new, by malloc and its kin, in our code or in that of
// the libraries that we call.
#pragma once

#include <cstdint>
#include <optional>

namespace cleave::workbench {

// Allocations of the calling thread up to now. A program that links this has its malloc replaced by
// one that counts and then does what glibc's does. Nothing where a sanitizer has replaced malloc
// itself.
[[nodiscard]] std::optional<std::uint64_t> allocations_of_this_thread();

}  // namespace cleave::workbench
