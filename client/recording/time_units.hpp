// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace cleave::recording {

inline constexpr std::int64_t ns_per_s = 1'000'000'000;

// Negative where time went back. Of any two times: they may be so far apart that only the
// difference of unsigned numbers holds it.
[[nodiscard]] constexpr double seconds_between(std::int64_t before_ns, std::int64_t after_ns) {
  const auto before = static_cast<std::uint64_t>(before_ns);
  const auto after = static_cast<std::uint64_t>(after_ns);
  const double ns = before_ns <= after_ns ? static_cast<double>(after - before)
                                          : -static_cast<double>(before - after);
  return ns / static_cast<double>(ns_per_s);
}

}  // namespace cleave::recording
