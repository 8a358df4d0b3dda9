// SPDX-License-Identifier: BSD-3-Clause
// What may name a network interface, wherever a user writes one.
#pragma once

#include <string_view>

namespace cleave {

// A name or an address: it becomes part of the XML that configures DDS.
[[nodiscard]] inline bool is_interface_name(std::string_view name) {
  constexpr std::string_view allowed =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.:_-@%";
  return !name.empty() && name.find_first_not_of(allowed) == std::string_view::npos;
}

}  // namespace cleave
