// The order in which people number files: frame2 before frame10.
#pragma once

#include <string_view>

namespace cleave::client {

// Runs of digits compare by value, all else by character; equal values by fewer leading zeros.
// A strict weak order in which only equal texts are equivalent.
[[nodiscard]] bool natural_less(std::string_view a, std::string_view b);

}  // namespace cleave::client
