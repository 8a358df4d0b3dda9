// SPDX-License-Identifier: BSD-3-Clause
// Numbers as PCD files write them in text, whatever the locale.
#pragma once

#include <cstdint>
#include <string_view>

#include "recording/pcd/header.hpp"

namespace cleave::recording {

// Writes the number that `word` says as one element of `field` to `to`, where that is of
// floating point rounded to double first, as PCL does; "nan" and "inf" with any sign and case among
// them. An integer may be written as a decimal (1.0, 2e3), negative in an unsigned field, or up to
// the unsigned range in a signed one: it keeps the bits that such writers mean; nan is 0, as for
// PCL. Returns what is wrong with the word ("is no number"), or nullptr.
[[nodiscard]] const char* write_number(std::string_view word, const PcdField& field,
                                       std::uint8_t* to);

}  // namespace cleave::recording
