// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/bench/allocation_counter.hpp"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)

namespace cleave::workbench {

std::optional<std::uint64_t> allocations_of_this_thread() {
  return std::nullopt;
}

}  // namespace cleave::workbench

#else

#include <cerrno>
#include <cstddef>

namespace {
// In the program's own storage: the first access by a thread must not allocate.
constinit thread_local std::uint64_t allocations = 0;
}  // namespace

namespace cleave::workbench {

std::optional<std::uint64_t> allocations_of_this_thread() {
  return allocations;
}

}  // namespace cleave::workbench

// A program's malloc takes precedence over the C library's, for all libraries that the program
// loads ("Replacing malloc" in glibc's manual); these names are glibc's own entry points.
extern "C" {
void* __libc_malloc(std::size_t size);                           // NOLINT
void* __libc_calloc(std::size_t count, std::size_t size);        // NOLINT
void* __libc_realloc(void* memory, std::size_t size);            // NOLINT
void* __libc_memalign(std::size_t alignment, std::size_t size);  // NOLINT

void* malloc(std::size_t size) {
  ++allocations;
  return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) {
  ++allocations;
  return __libc_calloc(count, size);
}

void* realloc(void* memory, std::size_t size) {
  ++allocations;
  return __libc_realloc(memory, size);
}

void* memalign(std::size_t alignment, std::size_t size) {
  ++allocations;
  return __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
  ++allocations;
  return __libc_memalign(alignment, size);
}

int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
  const bool power_of_two = (alignment & (alignment - 1)) == 0;
  if (alignment == 0 || alignment % sizeof(void*) != 0 || !power_of_two) return EINVAL;
  ++allocations;
  void* const found = __libc_memalign(alignment, size);
  if (found == nullptr) return ENOMEM;
  *memory = found;
  return 0;
}
}

#endif
