// SPDX-License-Identifier: BSD-3-Clause
#include "recording/cloud/decimal_digits.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace cleave::recording {
namespace {

constexpr int lowest_exponent = -20;  // of 2: about a micrometre
constexpr int highest_exponent = 19;  // about 500 km

struct Decade {
  double factor;      // turns 7 digits into an integer
  double next_power;  // of ten, from which on the next factor holds
  double next_factor;
};

// By the power of two that is not above a number: at most one power of ten lies between that and
// the next power of two.
constexpr auto decades = [] {
  std::array<Decade, highest_exponent - lowest_exponent + 1> result{};
  double two = 1;
  for (int i = 0; i > lowest_exponent; --i) two /= 2;
  double factor = 1e13;  // of the smallest; powers of ten up to 10^22 are exact
  for (Decade& decade : result) {
    while (two * factor >= 1e7) factor /= 10;
    decade = {factor, 1e7 / factor, factor / 10};
    two *= 2;
  }
  return result;
}();

// To the nearest whole number, ties to even: adding 2^52 leaves no room for a fraction.
double round_to_integer(double x) {
  constexpr double shift = 4503599627370496.0;
  return (x + shift) - shift;
}

}  // namespace

float round_to_7_digits(double x) {
  const double a = std::fabs(x);
  const int exponent = static_cast<int>(std::bit_cast<std::uint64_t>(a) >> 52U) - 1023;  // of 2
  if (exponent < lowest_exponent || exponent > highest_exponent) return static_cast<float>(x);
  const Decade& decade = decades[static_cast<std::size_t>(exponent - lowest_exponent)];
  const double factor = a >= decade.next_power ? decade.next_factor : decade.factor;
  return static_cast<float>(std::copysign(round_to_integer(a * factor) / factor, x));
}

}  // namespace cleave::recording
