// SPDX-License-Identifier: BSD-3-Clause
// Do the bytes of a recording mean what this version of Cleave takes them for?
#pragma once

#include <string_view>

namespace cleave::recording {

// Whether a recording's schema, OMG IDL, defines the types that this library reads as the contract
// of this version does. Comments and layout, other types, and those that are not there do not
// matter.
[[nodiscard]] bool is_of_this_contract(std::string_view schema);

}  // namespace cleave::recording
