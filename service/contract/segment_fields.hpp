// SPDX-License-Identifier: BSD-3-Clause
// From the segmentation's types to those that mirror the contract, whatever carries them: the
// stream's C structs or a recording's.
#pragma once

#include <Eigen/Geometry>

#include "idl/fields.hpp"
#include "segmentation/segmentation.hpp"

namespace cleave::service {

struct CopySegmentFields {
  template <class Number>
  void number(const char* /*name*/, const Number& from, Number& to) {
    to = from;
  }
  // The contract's enumerations have the segmentation's values in the segmentation's order.
  template <class From, class To>
  void choice(const char* /*name*/, const From& from, To& to) {
    to = static_cast<To>(from);
  }
  template <class List, class From, class To>
  void group(const char* /*name*/, const List& list, const From& from, To& to) {
    list(*this, from, to);
  }
  template <class To>
  void group(const char* /*name*/, const fields::PointFields& /*list*/, const Eigen::Vector3f& from,
             To& to) {
    to = {from.x(), from.y(), from.z()};
  }
  template <class To>
  void group(const char* /*name*/, const fields::QuaternionFields& /*list*/,
             const Eigen::Quaternionf& from, To& to) {
    to = {from.x(), from.y(), from.z(), from.w()};
  }
};

inline void copy_fields(const segmentation::Segment& from, auto& to) {
  fields::segment(CopySegmentFields{}, from, to);
}

inline void copy_fields(const segmentation::Border& from, auto& to) {
  fields::border(CopySegmentFields{}, from, to);
}

}  // namespace cleave::service
