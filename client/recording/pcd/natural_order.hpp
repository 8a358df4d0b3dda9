// SPDX-License-Identifier: BSD-3-Clause
// The order that people expect of numbered files: scene2 before scene10.
#pragma once

#include <string_view>

namespace cleave::recording {

// Whether `a` comes before `b`: runs of digits compare as numbers, of any length; all else by
// character. Names that differ only in leading zeros, or not at all, are ordered as texts, so the
// order is total.
[[nodiscard]] bool natural_less(std::string_view a, std::string_view b);

}  // namespace cleave::recording
