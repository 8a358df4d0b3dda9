#include "recording/cloud/decimal_digits.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace cleave::recording {
namespace {

// Powers of ten from 1e-6 to 1e6: coordinates in metres from a micrometre to 1000 km.
constexpr int lowest = -6;
constexpr std::array power = {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1e0,
                              1e1,  1e2,  1e3,  1e4,  1e5,  1e6};
// 10^(6 - exponent): turns 7 digits into an integer. All are exact.
constexpr std::array scale = {1e12, 1e11, 1e10, 1e9, 1e8, 1e7, 1e6, 1e5, 1e4, 1e3, 1e2, 1e1, 1e0};

// Entry of `power` that is not above `a`, which is within the table. Most coordinates are about a
// metre: the search begins there.
std::size_t decade_of(double a) {
  std::size_t i = static_cast<std::size_t>(-lowest);
  while (a < power[i]) --i;
  while (i + 1 < power.size() && a >= power[i + 1]) ++i;
  return i;
}

}  // namespace

float round_to_7_digits(double x) {
  const double a = std::fabs(x);
  if (!(a >= power.front() && a < power.back())) return static_cast<float>(x);
  const double factor = scale[decade_of(a)];
  return static_cast<float>(std::copysign(std::nearbyint(a * factor) / factor, x));
}

}  // namespace cleave::recording
