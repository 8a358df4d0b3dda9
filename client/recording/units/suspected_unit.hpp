// SPDX-License-Identifier: BSD-3-Clause
// Millimetres are told from metres, so that nobody segments a table of a kilometre.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>

#include "recording/units/unit.hpp"

namespace cleave::recording {

struct Suspicion {
  Unit unit = Unit::millimetre;
  std::string evidence;  // "a camera saw its points ..., which no depth camera measures in metres"
};

// Numbers alone do not say their unit: a terrain of 1 m steps and a scan of 1 mm steps have the
// same. A camera is what tells: focal length has no unit, and no depth camera sees farther than
// some ten metres. So a cloud is suspected of millimetres only if all of this holds:
// - It was seen from the origin: all z > 0, within 70 degrees of the axis, but for a few strays.
// - It is a camera's image, in whatever order its points are: in (x/z, y/z) the nearest
//   neighbours are one pixel apart, all alike (roughly, where all coordinates were rounded to
//   whole numbers), and more alike than in (x, y), where those of a terrain model are alike.
// - The nearest points (1 %) are beyond 100; of 20, if depths are whole numbers, as sensors give
//   them. Neighbouring pixels are 0.1 and more apart: closer ones at such a distance are a long
//   lens's.
// Never suspected, therefore: lidar scans (nearer, or behind the sensor), terrain, clouds in a
// map's frame, filtered ones, and few points (200); a cloud in millimetres that has lost its image,
// by a filter or in a robot's frame, is not told. Centimetres never are: 100 of them may be metres.
//
// `xyz`: 3 floats a point; points that are not finite, or 0 0 0, do not count. Cheap for clouds in
// metres: a few points are looked at. Deterministic.
[[nodiscard]] std::optional<Suspicion> suspected_unit(std::span<const float> xyz);

// A file whose coordinates seem to be in another unit; what() names it, the evidence, and --unit.
class WrongUnit : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// With a unit, scales. Without one, throws WrongUnit if `xyz` is suspected of another than metres.
// `what` is named in the message.
void make_metres(std::span<float> xyz, std::optional<Unit> unit, const std::string& what);

}  // namespace cleave::recording
