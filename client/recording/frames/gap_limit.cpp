// SPDX-License-Identifier: BSD-3-Clause
#include "recording/frames/gap_limit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "recording/time_units.hpp"

namespace cleave::recording {
namespace {

// "11.0 days", "2.5 s".
std::string readable(double seconds) {
  struct Unit {
    double seconds;
    const char* name;
  };
  constexpr std::array units = {Unit{86'400, "days"}, Unit{3'600, "hours"}, Unit{60, "minutes"}};
  const auto* const unit = std::ranges::find_if(
      units, [seconds](const Unit& u) { return std::abs(seconds) >= 2 * u.seconds; });
  const bool found = unit != units.end();
  std::array<char, 64> text{};
  (void)std::snprintf(text.data(), text.size(), "%.3g %s",
                      std::abs(seconds) / (found ? unit->seconds : 1), found ? unit->name : "s");
  return text.data();
}

}  // namespace

GapLimit::GapLimit(double longest_s)
    : longest_(std::llround(longest_s * static_cast<double>(ns_per_s))) {}

GapLimit::Gap GapLimit::between(std::int64_t before_ns, std::int64_t after_ns) const {
  if (after_ns < before_ns) return {std::chrono::nanoseconds(0), true};
  // Times may be so far apart that only the difference of unsigned numbers holds it.
  const std::uint64_t gap =
      static_cast<std::uint64_t>(after_ns) - static_cast<std::uint64_t>(before_ns);
  if (gap > static_cast<std::uint64_t>(longest_.count())) return {longest_, true};
  return {std::chrono::nanoseconds(static_cast<std::int64_t>(gap)), false};
}

std::string GapLimit::text_of_jump(std::int64_t before_ns, std::int64_t after_ns) const {
  const double jump_s = seconds_between(before_ns, after_ns);
  const double wait_s = static_cast<double>(between(before_ns, after_ns).wait.count()) /
                        static_cast<double>(ns_per_s);
  return "the recording's clock goes " + std::string(jump_s < 0 ? "back by " : "on by ") +
         readable(jump_s) + " between two frames; playing on after " + readable(wait_s) +
         " (--max-gap); further gaps are not named";
}

}  // namespace cleave::recording
