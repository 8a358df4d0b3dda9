// SPDX-License-Identifier: BSD-3-Clause
// The contract's types as JSON, with the keys of the IDL.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "console/json.hpp"
#include "idl/fields.hpp"
#include "recording/frames/frame.hpp"

namespace cleave {

// Points and quaternions are lists, [x, y, z] and [x, y, z, w]; kinds and outcomes are words.
[[nodiscard]] Json contract_json(const recording::SegmentList& list);
[[nodiscard]] Json contract_json(const recording::Segment& segment);
[[nodiscard]] Json contract_json(const recording::Border& border);

// The values of a type's fields (idl/fields.hpp), one key after the other.
struct JsonFields {
  Json json = Json::object();

  void number(const char* name, const float& value) { json[name] = decimal(value); }
  template <class Number>
  void number(const char* name, const Number& value) {
    json[name] = value;
  }
  template <class Enum>
  void choice(const char* name, const Enum& value) {
    json[name] = name_of(value);  // found beside the enumeration
  }
  void text(const char* name, const std::string& value) { json[name] = value; }
  template <class List, class Value>
  void group(const char* name, const List& list, const Value& value) {
    JsonFields fields;
    list(fields, value);
    json[name] = std::move(fields.json);
  }
  void group(const char* name, const fields::PointFields& /*list*/, const recording::Point& p) {
    json[name] = {decimal(p.x), decimal(p.y), decimal(p.z)};
  }
  void group(const char* name, const fields::QuaternionFields& /*list*/,
             const recording::Quaternion& q) {
    json[name] = {decimal(q.x), decimal(q.y), decimal(q.z), decimal(q.w)};
  }
  template <class List, class Value>
  void each(const char* name, const List& list, const std::vector<Value>& values) {
    Json& array = json[name] = Json::array();
    for (const Value& value : values) {
      JsonFields fields;
      list(fields, value);
      array.push_back(std::move(fields.json));
    }
  }
};

}  // namespace cleave
