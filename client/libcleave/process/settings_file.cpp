// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/process/settings_file.hpp"

#include <stdexcept>
#include <string>
#include <system_error>

namespace cleave {

std::filesystem::path settings_file(std::string_view name) {
  const auto program = std::filesystem::read_symlink("/proc/self/exe");
  const auto installed = program.parent_path().parent_path() / "etc" / "cleave" / name;
  const auto common = std::filesystem::path("/etc/cleave") / name;
  for (const std::filesystem::path& place : {installed, common}) {
    std::error_code unreadable;  // is as good as not there
    if (std::filesystem::exists(place, unreadable)) return place;
  }
  throw std::invalid_argument("there is neither " + installed.string() + " nor " + common.string() +
                              "; name a file with --config");
}

}  // namespace cleave
