// SPDX-License-Identifier: BSD-3-Clause
// Functions whose last bit does not depend on the processor, as that of the C library's may. Only
// operations that IEEE 754 rounds exactly: + - * / and sqrt.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace cleave::segmentation::portable {

// Within 3e-8 of the exact value (Abramowitz and Stegun, 4.4.46); |x| <= 1.
[[nodiscard]] inline double acos(double x) {
  constexpr std::array coefficients = {-0.0012624911, 0.0066700901, -0.0170881256, 0.0308918810,
                                       -0.0501743046, 0.0889789874, -0.2145988016, 1.5707963050};
  const double magnitude = std::abs(x);
  double sum = 0;
  for (const double c : coefficients) sum = sum * magnitude + c;
  const double angle_rad = std::sqrt(1 - magnitude) * sum;
  return x < 0 ? std::numbers::pi - angle_rad : angle_rad;
}

// 1/0!, 1/1!, 1/2!, ...: of Taylor's series.
inline constexpr auto inverse_factorials = [] {
  std::array<double, 18> inverse{};
  double factorial = 1;
  for (std::size_t k = 0; k < inverse.size(); ++k) {
    if (k > 0) factorial *= static_cast<double>(k);
    inverse[k] = 1 / factorial;
  }
  return inverse;
}();

// Within 1e-13; |x| <= pi / 2.
[[nodiscard]] constexpr double sin(double x) {
  double sum = 0;
  for (std::size_t k = 17; k >= 3; k -= 2) sum = (inverse_factorials[k] - sum) * x * x;
  return x - x * sum;
}

// Within 1e-13; 0 <= x <= pi.
[[nodiscard]] constexpr double cos(double x) {
  return sin(std::numbers::pi / 2 - x);
}

// Relative error below 1e-13; beyond +-700, the value there.
[[nodiscard]] inline double exp(double x) {
  x = x < -700 ? -700 : x > 700 ? 700 : x;
  const double halvings = std::floor(x / std::numbers::ln2 + 0.5);
  const double rest = x - halvings * std::numbers::ln2;
  double sum = 0;
  for (std::size_t k = 12; k > 0; --k) sum = (sum + inverse_factorials[k]) * rest;
  sum += 1;
  constexpr int bias = 1023;
  constexpr int fraction_bits = 52;
  const auto exponent = static_cast<std::uint64_t>(static_cast<std::int64_t>(halvings) + bias);
  return sum * std::bit_cast<double>(exponent << fraction_bits);
}

// Within 3e-7 of the exact value or of the value's own size; x > 0, normal. Without a branch, so
// that loops over it are vectorised.
[[nodiscard]] inline float log(float x) {
  // x = 2^exponent * mantissa, mantissa between sqrt(1/2) and sqrt(2).
  constexpr std::int32_t sqrt_half_bits = 0x3F3504F3;
  constexpr int fraction_bits = 23;
  const auto bits = std::bit_cast<std::int32_t>(x);
  const std::int32_t exponent = (bits - sqrt_half_bits) >> fraction_bits;
  const auto mantissa = std::bit_cast<float>(bits - exponent * (1 << fraction_bits));
  const float s = (mantissa - 1) / (mantissa + 1);
  const float ss = s * s;
  const float series =
      2 * s * (1 + ss * (1 / 3.0F + ss * (1 / 5.0F + ss * (1 / 7.0F + ss / 9.0F))));
  return static_cast<float>(exponent) * std::numbers::ln2_v<float> + series;
}

}  // namespace cleave::segmentation::portable
