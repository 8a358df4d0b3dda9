// SPDX-License-Identifier: BSD-3-Clause
// The points of a PCD file, in each of its encodings.
#pragma once

#include <cstdint>
#include <vector>

#include "recording/pcd/header.hpp"

namespace cleave::recording {

// The bytes of all points one after the other, fields in the header's order, padding left out.
// `input` stands behind the header; what follows the last point is passed over. Nothing is
// allocated that the file's size does not bear out. Throw PcdError: the file holds fewer points
// than the header promises (and how many), or they cannot be decoded.
[[nodiscard]] std::vector<std::uint8_t> read_ascii(PcdInput& input, const PcdHeader& header);
[[nodiscard]] std::vector<std::uint8_t> read_binary(PcdInput& input, const PcdHeader& header);
[[nodiscard]] std::vector<std::uint8_t> read_compressed(PcdInput& input, const PcdHeader& header);

// The fields that hold something.
[[nodiscard]] std::vector<PcdField> without_padding(std::vector<PcdField> fields);

// Refuses a file that ends after `found` points.
[[noreturn]] void refuse_truncated(const PcdInput& input, const PcdHeader& header,
                                   std::uint64_t found);

}  // namespace cleave::recording
