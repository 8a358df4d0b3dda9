// SPDX-License-Identifier: BSD-3-Clause
// Which of OpenNI2's devices is meant, and its opening.
#pragma once

#include <OpenNI.h>

#include <string>

#include "sensor/sources/source.hpp"

namespace cleave::sensor {

struct OpenResult {
  Failure failure;
  bool in_use = false;  // it is there, but cannot be had now
};

// Opens the device with this URI; with "serial=TEXT" the one with this serial number, for which
// every device is opened in turn; with "" the first one.
[[nodiscard]] OpenResult open_device(openni::Device& device, const std::string& uri);

}  // namespace cleave::sensor
