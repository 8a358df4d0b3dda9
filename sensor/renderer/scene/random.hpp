// SPDX-License-Identifier: BSD-3-Clause
// Random numbers that are the same on every platform, which the standard's distributions are not.
#pragma once

#include <cstdint>

namespace cleave::render {

// SplitMix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", OOPSLA
// 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t mixed = state_;
    mixed = (mixed ^ (mixed >> 30U)) * 0xBF58476D1CE4E5B9U;
    mixed = (mixed ^ (mixed >> 27U)) * 0x94D049BB133111EBU;
    return mixed ^ (mixed >> 31U);
  }

  // In [low, high).
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(next() >> 11U) * 0x1.0p-53);
  }

  // In {0, ..., count - 1}.
  std::uint32_t below(std::uint32_t count) {
    return static_cast<std::uint32_t>(((next() >> 32U) * count) >> 32U);
  }

  bool chance(double probability) { return uniform(0, 1) < probability; }

  // Mean 0, variance 1: the sum of four 16-bit uniforms (Irwin-Hall), so no mathematics library is
  // involved and one draw is enough. Its tails end at 3.46.
  float normal() {
    constexpr float mean = 131070.0F;
    constexpr float standard_deviation = 37837.2F;
    const std::uint64_t bits = next();
    const std::uint64_t sum =
        (bits & 0xFFFFU) + ((bits >> 16U) & 0xFFFFU) + ((bits >> 32U) & 0xFFFFU) + (bits >> 48U);
    return (static_cast<float>(sum) - mean) / standard_deviation;
  }

 private:
  std::uint64_t state_;
};

// A seed of its own for each of `stream`'s values, unrelated to those of other seeds.
inline std::uint64_t derived_seed(std::uint64_t seed, std::uint64_t stream) {
  return Random(seed ^ Random(~stream).next()).next();
}

}  // namespace cleave::render
