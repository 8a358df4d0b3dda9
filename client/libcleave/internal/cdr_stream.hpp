// SPDX-License-Identifier: BSD-3-Clause
// Cyclone's own serialisation, without a topic or a domain.
#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>
#include <vector>

#include "libcleave/internal/raw_reader.hpp"
#include "libcleave/types.hpp"

namespace cleave {

// Bytes that are no sample of the type that was asked for.
struct CdrError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

[[nodiscard]] RawSample decode_cdr(const dds_topic_descriptor_t* type,
                                   std::span<const std::byte> bytes);
[[nodiscard]] std::vector<std::byte> encode_cdr(const dds_topic_descriptor_t* type,
                                                const void* sample);

}  // namespace cleave
