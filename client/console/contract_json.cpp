// SPDX-License-Identifier: BSD-3-Clause
#include "console/contract_json.hpp"

namespace cleave {
namespace {

template <class List, class Value>
Json json_by(const List& list, const Value& value) {
  JsonFields fields;
  list(fields, value);
  return std::move(fields.json);
}

}  // namespace

Json contract_json(const recording::SegmentList& list) {
  return json_by(fields::segment_list, list);
}

Json contract_json(const recording::Segment& segment) {
  return json_by(fields::segment, segment);
}

Json contract_json(const recording::Border& border) {
  return json_by(fields::border, border);
}

}  // namespace cleave
