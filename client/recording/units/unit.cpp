// SPDX-License-Identifier: BSD-3-Clause
#include "recording/units/unit.hpp"

#include <algorithm>

namespace cleave::recording {
namespace {

constexpr std::array<double, 3> per_metre = {1, 100, 1000};
constexpr std::array<std::string_view, 3> plurals = {"metres", "centimetres", "millimetres"};

}  // namespace

std::optional<Unit> unit_named(std::string_view name) {
  const auto* const found = std::find(unit_names.begin(), unit_names.end(), name);
  if (found == unit_names.end()) return std::nullopt;
  return static_cast<Unit>(found - unit_names.begin());
}

std::string_view plural_of(Unit unit) {
  return plurals.at(static_cast<std::size_t>(unit));
}

double units_a_metre(Unit unit) {
  return per_metre.at(static_cast<std::size_t>(unit));
}

void scale_to_metres(std::span<float> xyz, Unit unit) {
  if (unit == Unit::metre) return;
  const double divisor = units_a_metre(unit);
  for (float& value : xyz) value = static_cast<float>(static_cast<double>(value) / divisor);
}

}  // namespace cleave::recording
