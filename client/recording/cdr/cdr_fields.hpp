// SPDX-License-Identifier: BSD-3-Clause
// The fields of a contract's type (idl/fields.hpp) to CDR and back.
#pragma once

#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

#include "recording/cdr/cdr.hpp"

namespace cleave::recording {

inline constexpr std::size_t cdr_name_size = 64;  // of the contract's char arrays

struct CdrFieldWriter {
  CdrWriter& cdr;

  template <class Number>
  void number(const char* /*name*/, const Number& value) {
    cdr.number(value);
  }
  template <class Enum>
  void choice(const char* /*name*/, const Enum& value) {
    cdr.number(static_cast<std::underlying_type_t<Enum>>(value));
  }
  // Throws DataError for a text of more than 63 characters.
  void text(const char* /*name*/, const std::string& value) {
    cdr.characters(value, cdr_name_size);
  }
  template <class List, class Value>
  void group(const char* /*name*/, const List& list, const Value& value) {
    list(*this, value);
  }
  template <class List, class Value>
  void each(const char* /*name*/, const List& list, const std::vector<Value>& values) {
    cdr.length(values.size());
    for (const Value& value : values) list(*this, value);
  }
};

// How many bytes the numbers of a type take, padding not counted.
struct CdrLeastSize {
  std::size_t bytes = 0;

  template <class Number>
  void number(const char* /*name*/, const Number& /*value*/) {
    bytes += sizeof(Number);
  }
  template <class Enum>
  void choice(const char* /*name*/, const Enum& /*value*/) {
    bytes += sizeof(Enum);
  }
  template <class List, class Value>
  void group(const char* /*name*/, const List& list, const Value& value) {
    list(*this, value);
  }
};

// Throws DataError for what is too short, and for a text without end.
struct CdrFieldReader {
  CdrReader& cdr;

  template <class Number>
  void number(const char* /*name*/, Number& value) {
    value = cdr.number<Number>();
  }
  template <class Enum>
  void choice(const char* /*name*/, Enum& value) {
    value = static_cast<Enum>(cdr.number<std::underlying_type_t<Enum>>());
  }
  void text(const char* /*name*/, std::string& value) { value = cdr.characters(cdr_name_size); }
  template <class List, class Value>
  void group(const char* /*name*/, const List& list, Value& value) {
    list(*this, value);
  }
  template <class List, class Value>
  void each(const char* /*name*/, const List& list, std::vector<Value>& values) {
    CdrLeastSize least;
    const Value none{};
    list(least, none);
    values.resize(cdr.length(least.bytes));
    for (Value& value : values) list(*this, value);
  }
};

}  // namespace cleave::recording
