// SPDX-License-Identifier: BSD-3-Clause
// Samples as the JSON of the golden files: the IDL's names of fields and enumerators. Integers of
// 64 bits are texts, and so are "NaN", "Infinity" and "-Infinity": see idl/README.md.
#pragma once

#include <cmath>
#include <concepts>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "console/json.hpp"
#include "libcleave/sequence.hpp"
#include "libcleave/types.hpp"
#include "recording/frames/frame.hpp"

namespace cleave::test {

// The IDL's name of an enumeration, of which there are mirrors.
inline const char* enumeration_of(cleave_v1_BorderKind /*kind*/) {
  return "BorderKind";
}
inline const char* enumeration_of(cleave_v1_FrameOutcome /*outcome*/) {
  return "FrameOutcome";
}
inline const char* enumeration_of(cleave_v1_NodeState /*state*/) {
  return "NodeState";
}
inline const char* enumeration_of(cleave_v1_Transport /*transport*/) {
  return "Transport";
}
inline const char* enumeration_of(recording::BorderKind /*kind*/) {
  return "BorderKind";
}
inline const char* enumeration_of(recording::FrameOutcome /*outcome*/) {
  return "FrameOutcome";
}

// The IDL's name of its `index`th enumerator. Throws std::out_of_range.
[[nodiscard]] std::string enumerator(const std::string& enumeration, std::size_t index);

template <std::integral Number>
[[nodiscard]] nlohmann::json json_of(Number value) {
  if constexpr (sizeof(Number) == 8) return std::to_string(value);
  return value;
}
template <std::floating_point Number>
[[nodiscard]] nlohmann::json json_of(Number value) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value > 0 ? "Infinity" : "-Infinity";
  if constexpr (std::same_as<Number, float>) return decimal(value);
  return value;
}

template <class Value>
[[nodiscard]] std::span<const Value> all_of(const std::vector<Value>& values) {
  return values;
}
template <class Sequence>
[[nodiscard]] auto all_of(const Sequence& sequence) {
  return elements_of(sequence);
}

// Visits a list of idl/fields.hpp.
struct IdlJson {
  nlohmann::json json = nlohmann::json::object();

  template <class Number>
  void number(const char* name, const Number& value) {
    json[name] = json_of(value);
  }
  template <class Enum>
  void choice(const char* name, const Enum& value) {
    json[name] = enumerator(enumeration_of(value), static_cast<std::size_t>(value));
  }
  template <class Text>
  void text(const char* name, const Text& value) {
    json[name] = std::string(value);
  }
  template <class List, class Value>
  void group(const char* name, const List& list, const Value& value) {
    IdlJson fields;
    list(fields, value);
    json[name] = std::move(fields.json);
  }
  template <class List, class Values>
  void each(const char* name, const List& list, const Values& values) {
    json[name] = nlohmann::json::array();
    for (const auto& value : all_of(values)) {
      IdlJson fields;
      list(fields, value);
      json[name].push_back(std::move(fields.json));
    }
  }
};

}  // namespace cleave::test
