// SPDX-License-Identifier: BSD-3-Clause
// The fields of a contract's type (idl/fields.hpp) to CDR and back.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include "recording/cdr/cdr.hpp"
#include "recording/cdr/lacking_fields.hpp"

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

// The fields that the bytes of a type do not have, because it had fewer when they were written.
class CdrLacks {
 public:
  // Of `type`; `all` outlives this.
  CdrLacks(const LackingFields& all, const char* type) : all_(&all) {
    if (const auto found = all.find(type); found != all.end()) here_ = &found->second;
  }
  [[nodiscard]] bool operator()(const char* name) const {
    return here_ != nullptr && here_->contains(name);
  }
  [[nodiscard]] CdrLacks of(const char* type) const { return {*all_, type}; }

 private:
  const LackingFields* all_;
  const std::set<std::string, std::less<>>* here_ = nullptr;
};

// How many bytes the numbers of a type take, padding not counted.
struct CdrLeastSize {
  CdrLacks lacks;
  std::size_t bytes = 0;

  template <class Number>
  void number(const char* name, const Number& /*value*/) {
    if (!lacks(name)) bytes += sizeof(Number);
  }
  template <class Enum>
  void choice(const char* name, const Enum& /*value*/) {
    if (!lacks(name)) bytes += sizeof(Enum);
  }
  template <class List, class Value>
  void group(const char* name, const List& list, const Value& value) {
    if (lacks(name)) return;
    CdrLeastSize group{lacks.of(List::type)};
    list(group, value);
    bytes += group.bytes;
  }
};

// What is lacking stays as it is. Throws DataError for what is too short, and for a text without
// end.
struct CdrFieldReader {
  CdrReader& cdr;
  CdrLacks lacks;

  template <class Number>
  void number(const char* name, Number& value) {
    if (!lacks(name)) value = cdr.number<Number>();
  }
  template <class Enum>
  void choice(const char* name, Enum& value) {
    if (!lacks(name)) value = static_cast<Enum>(cdr.number<std::underlying_type_t<Enum>>());
  }
  void text(const char* name, std::string& value) {
    if (!lacks(name)) value = cdr.characters(cdr_name_size);
  }
  template <class List, class Value>
  void group(const char* name, const List& list, Value& value) {
    if (!lacks(name)) list(CdrFieldReader{cdr, lacks.of(List::type)}, value);
  }
  template <class List, class Value>
  void each(const char* name, const List& list, std::vector<Value>& values) {
    if (lacks(name)) return;
    const CdrLacks inner = lacks.of(List::type);
    CdrLeastSize least{inner};
    const Value none{};
    list(least, none);
    values.resize(cdr.length(least.bytes));
    for (Value& value : values) list(CdrFieldReader{cdr, inner}, value);
  }
};

}  // namespace cleave::recording
