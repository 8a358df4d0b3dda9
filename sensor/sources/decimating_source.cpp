// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/sources/decimating_source.hpp"

namespace cleave::sensor {

Poll DecimatingSource::next(std::chrono::milliseconds timeout, Frame& frame) {
  const Poll poll = source().next(timeout, whole_);
  if (poll != Poll::frame) return poll;
  frame = whole_;
  if (whole_.height == 1) return poll;
  frame.width = decimator_.width(whole_.width);
  frame.height = decimator_.height(whole_.height);
  frame.intrinsics = decimator_.intrinsics(whole_.intrinsics);
  return poll;
}

void DecimatingSource::write_points(float* xyz) {
  if (whole_.height == 1) return source().write_points(xyz);
  xyz_.resize(3 * std::size_t{whole_.width} * whole_.height);
  source().write_points(xyz_.data());
  decimator_.decimate(xyz_.data(), whole_.width, whole_.height, whole_.intrinsics, xyz);
}

}  // namespace cleave::sensor
