#pragma once

#include <cstdint>

namespace cleave::recording {

inline constexpr std::int64_t ns_per_s = 1'000'000'000;

}  // namespace cleave::recording
