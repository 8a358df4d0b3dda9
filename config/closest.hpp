// SPDX-License-Identifier: BSD-3-Clause
// What a user may have meant by a word that is not known.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cleave::config {

// The candidate with the smallest edit distance (insert, delete, replace a character), the first of
// several; empty when even that one differs in more than a third of the word (but 2 edits are
// always allowed).
[[nodiscard]] std::string closest(std::string_view word,
                                  const std::vector<std::string>& candidates);

}  // namespace cleave::config
