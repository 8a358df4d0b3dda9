// SPDX-License-Identifier: BSD-3-Clause
// Lengths that files are in. Everything inside is in metres: who reads a file scales.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace cleave::recording {

enum class Unit : std::uint8_t { metre, centimetre, millimetre };

// What users write, in the order of the enumeration.
inline constexpr std::array<std::string_view, 3> unit_names = {"m", "cm", "mm"};

[[nodiscard]] std::optional<Unit> unit_named(std::string_view name);

// "millimetres"
[[nodiscard]] std::string_view plural_of(Unit unit);

// 1, 100 or 1000.
[[nodiscard]] double units_a_metre(Unit unit);

// Each number divided by how many units a metre has, rounded once. Metres are left alone.
void scale_to_metres(std::span<float> xyz, Unit unit);

}  // namespace cleave::recording
