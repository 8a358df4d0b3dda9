// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/data_folder.hpp"

#include <cstdlib>

namespace cleave::tests {

std::optional<std::filesystem::path> find_data(const std::filesystem::path& folder) {
  const char* chosen = std::getenv("CLEAVE_DATA");
  const auto path = std::filesystem::path(chosen != nullptr ? chosen : CLEAVE_DATA) / folder;
  if (!std::filesystem::exists(path)) return std::nullopt;
  return path;
}

}  // namespace cleave::tests
