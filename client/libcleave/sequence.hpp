// SPDX-License-Identifier: BSD-3-Clause
// Sequences of the contract's C types.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace cleave {

// The elements where they are.
template <class Sequence>
[[nodiscard]] auto elements_of(const Sequence& sequence) {
  return std::span(sequence._buffer, sequence._length);
}

// Points the sequence at the elements, which stay the vector's.
template <class Sequence, class Element>
void lend(Sequence& sequence, std::vector<Element>& elements) {
  sequence._length = static_cast<std::uint32_t>(elements.size());
  sequence._maximum = sequence._length;
  sequence._buffer = elements.data();
  sequence._release = false;
}

}  // namespace cleave
