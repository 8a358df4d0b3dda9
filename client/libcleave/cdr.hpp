// SPDX-License-Identifier: BSD-3-Clause
// Samples from and to the bytes in which they travel: XCDR1 behind 4 bytes of encapsulation, as
// recordings and every vendor's DDS have them. Needs no stream.
#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>
#include <vector>

#include "libcleave/internal/cdr_stream.hpp"
#include "libcleave/internal/raw_reader.hpp"
#include "libcleave/internal/topic.hpp"
#include "libcleave/types.hpp"

namespace cleave {

// The sample in `bytes`, of either byte order: for the constructors of Sample, CloudSample and
// LabelSample. Throws CdrError for what is cut off, has lengths that lie, a text without end, an
// enumerator that is none or anything behind it: nothing is allocated by a length that lies.
template <class T>
[[nodiscard]] RawSample sample_of_cdr(std::span<const std::byte> bytes) {
  return decode_cdr(topic_of<T>("").descriptor, bytes);
}

// In little endian. Throws CdrError for an enumerator that is none.
template <class T>
[[nodiscard]] std::vector<std::byte> cdr_of(const T& sample) {
  return encode_cdr(topic_of<T>("").descriptor, &sample);
}

}  // namespace cleave
