// SPDX-License-Identifier: BSD-3-Clause
// Parts of a list of scenes, by index.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace cleave::workbench {

class GroupError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Both ends belong to it.
struct Group {
  std::size_t first = 0;
  std::size_t last = 0;

  [[nodiscard]] std::string name() const;  // "0-15", "7"
};

// "0-15,16-23,30" for a list of so many scenes, numbered from 0; empty text = none. Throws
// GroupError, which says what was expected, for anything else and for what the list does not have.
[[nodiscard]] std::vector<Group> parse_groups(std::string_view text, std::size_t scenes);

}  // namespace cleave::workbench
