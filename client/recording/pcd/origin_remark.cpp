// SPDX-License-Identifier: BSD-3-Clause
#include "recording/pcd/origin_remark.hpp"

#include <array>
#include <charconv>

namespace cleave::recording {
namespace {

// So many that they are read back as the same number.
std::string digits(double number) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  return {text.data(), end};
}

}  // namespace

std::optional<std::string> OriginRemark::of(const std::filesystem::path& file,
                                            const StreamCloud& cloud) {
  if (made_ || cloud.origin == std::array<double, 3>{}) return std::nullopt;
  made_ = true;
  const auto& [x, y, z] = cloud.origin;
  return file.string() +
         ": its points are too far from zero for floats; they are kept relative to " + digits(x) +
         ' ' + digits(y) + ' ' + digits(z) +
         ", and those of further such files relative to a place near their own middle";
}

}  // namespace cleave::recording
