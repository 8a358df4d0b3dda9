// SPDX-License-Identifier: BSD-3-Clause
// The files of idl/golden, for tests in C++. idl/README.md says what is in them.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace cleave::test {

// One of a type's samples.
struct GoldenSample {
  std::string name;  // for messages: "SegmentList/typical"
  nlohmann::json json;
  std::vector<std::byte> little_endian;  // with 4 bytes of encapsulation, as is:
  std::vector<std::byte> big_endian;
};

// The samples of a type of the contract: "empty", "extreme" and "typical". Throws
// std::runtime_error where a file cannot be read.
[[nodiscard]] std::vector<GoldenSample> golden_samples(const std::string& type);

}  // namespace cleave::test
