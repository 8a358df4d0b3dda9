// SPDX-License-Identifier: BSD-3-Clause
// The compiler's portable vectors: element by element the same on every instruction set, and in
// registers as wide as there are.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

namespace cleave::segmentation {

using Float4 = float __attribute__((vector_size(16)));
using Float8 = float __attribute__((vector_size(32)));
using Double4 = double __attribute__((vector_size(32)));
using Int8 = std::int32_t __attribute__((vector_size(32)));

// References, because how vectors are passed by value depends on the instruction set.
template <typename Vector, typename Element>
inline __attribute__((always_inline)) void load(const Element* from, Vector& to) {
  std::memcpy(&to, from, sizeof(Vector));
}

template <typename Vector, typename Element>
inline __attribute__((always_inline)) void store(const Vector& from, Element* to) {
  std::memcpy(to, &from, sizeof(Vector));
}

// One instruction, once the loop is vectorised.
inline __attribute__((always_inline)) void square_root(Float8& x) {
  for (int i = 0; i < 8; ++i) x[i] = std::sqrt(x[i]);
}

}  // namespace cleave::segmentation
