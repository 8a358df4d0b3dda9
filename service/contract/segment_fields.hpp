// SPDX-License-Identifier: BSD-3-Clause
// From the segmentation's types to those that mirror the contract, whatever carries them: the
// stream's C structs or a recording's.
#pragma once

#include <Eigen/Geometry>

#include "idl/copy_fields.hpp"
#include "idl/fields.hpp"
#include "segmentation/segmentation.hpp"

namespace cleave::service {

struct CopySegmentFields : fields::Copy<CopySegmentFields> {
  using Copy::group;
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
