// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/process/companion.hpp"

#include <array>
#include <stdexcept>
#include <system_error>

namespace cleave {
namespace {

std::array<std::filesystem::path, 2> places_of(const std::filesystem::path& file) {
  const auto program = std::filesystem::read_symlink("/proc/self/exe");
  const auto folder = program.parent_path();
  return {folder / file, folder.parent_path() / "lib" / "cleave" / file};
}

}  // namespace

std::optional<std::filesystem::path> find_companion(const std::filesystem::path& file) {
  for (const std::filesystem::path& place : places_of(file)) {
    std::error_code unreadable;  // is as good as not there
    if (std::filesystem::exists(place, unreadable)) return place;
  }
  return std::nullopt;
}

std::string missing_companion(const std::filesystem::path& file, std::string_view remedy) {
  const auto [beside, installed] = places_of(file);
  return "there is neither " + beside.string() + " nor " + installed.string() + "; " +
         std::string(remedy);
}

std::filesystem::path companion(const std::filesystem::path& file, std::string_view remedy) {
  if (auto found = find_companion(file)) return *std::move(found);
  throw std::runtime_error(missing_companion(file, remedy));
}

}  // namespace cleave
