// SPDX-License-Identifier: BSD-3-Clause
// From one struct that mirrors a type of the contract to another (idl/fields.hpp).
#pragma once

namespace cleave::fields {

// What is the same whatever the two are. Texts and sequences, which each keeps in a way of its own,
// are for the visitor that derives from this.
template <class Visitor>
struct Copy {
  template <class Number>
  void number(const char* /*name*/, const Number& from, Number& to) {
    to = from;
  }
  // All mirrors of an enumeration have its values in its order.
  template <class From, class To>
  void choice(const char* /*name*/, const From& from, To& to) {
    to = static_cast<To>(from);
  }
  template <class List, class From, class To>
  void group(const char* /*name*/, const List& list, const From& from, To& to) {
    list(static_cast<Visitor&>(*this), from, to);
  }
};

}  // namespace cleave::fields
