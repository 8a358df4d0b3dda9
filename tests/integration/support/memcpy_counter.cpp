// SPDX-License-Identifier: BSD-3-Clause
#include "tests/integration/support/memcpy_counter.hpp"

#include <atomic>
#include <cstddef>

namespace {

std::atomic<std::uint64_t> count{0};

void note(std::size_t size) {
  if (size >= 100'000) count.fetch_add(1, std::memory_order_relaxed);
}

}  // namespace

// The program's own symbols come before the C library's, for every shared library that it loads.
// Volatile, so that the compiler does not turn the loop into a call of memcpy, which is this.
extern "C" void* memcpy(void* __restrict to, const void* __restrict from,
                        std::size_t size) noexcept {
  note(size);
  auto* t = static_cast<volatile unsigned char*>(to);
  const auto* f = static_cast<const unsigned char*>(from);
  for (std::size_t i = 0; i < size; ++i) t[i] = f[i];
  return to;
}

extern "C" void* memmove(void* to, const void* from, std::size_t size) noexcept {
  note(size);
  auto* t = static_cast<volatile unsigned char*>(to);
  const auto* f = static_cast<const unsigned char*>(from);
  if (t < f) {
    for (std::size_t i = 0; i < size; ++i) t[i] = f[i];
  } else {
    for (std::size_t i = size; i > 0; --i) t[i - 1] = f[i - 1];
  }
  return to;
}

namespace cleave::test {

std::uint64_t large_copies() {
  return count.load();
}

}  // namespace cleave::test
