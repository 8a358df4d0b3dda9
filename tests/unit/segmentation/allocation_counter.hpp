// Counts what the program takes from the heap. Replaces the C library's allocation functions, so it
// cannot be built with a sanitizer, which does the same.
#pragma once

#include <cstdint>

namespace cleave::segmentation {

// Calls of malloc, calloc, realloc, aligned_alloc and posix_memalign of this thread so far;
// operator new is one of them.
[[nodiscard]] std::uint64_t allocations();

}  // namespace cleave::segmentation
