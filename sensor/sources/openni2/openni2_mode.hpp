// SPDX-License-Identifier: BSD-3-Clause
// The depth mode of an OpenNI2 stream.
#pragma once

#include <OpenNI.h>

#include <string>

#include "sensor/sources/openni2/openni2_source.hpp"
#include "sensor/sources/source.hpp"

namespace cleave::sensor {

// A depth of 1 is a millimetre or a tenth of one; all else is not depth.
[[nodiscard]] bool is_depth(openni::PixelFormat format);

// "640x480@30"
[[nodiscard]] std::string describe(const openni::VideoMode& mode);

// Sets the wanted mode, in millimetres where the device has a choice; names the modes that there
// are if it is none of them.
[[nodiscard]] Failure set_mode(openni::VideoStream& stream, const VideoMode& wanted);

// Many cameras mirror unless they are told not to: left and right are then swapped.
[[nodiscard]] Failure set_mirroring(openni::VideoStream& stream, bool wanted);

// Registered depth is as seen by the device's colour sensor.
[[nodiscard]] Failure set_registration(openni::Device& device, bool wanted);

}  // namespace cleave::sensor
