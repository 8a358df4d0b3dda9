// SPDX-License-Identifier: BSD-3-Clause
// OpenNI2 as a library: its one initialisation, and its errors in words that help.
#pragma once

#include <OpenNI.h>

#include <string>

#include "sensor/sources/source.hpp"

namespace cleave::sensor {

// Initialises OpenNI2 once a process and never shuts it down: a second cycle leaks, and concurrent
// ones crash. OpenNI2 changes the working directory meanwhile; it is restored.
[[nodiscard]] Failure initialise_openni2();

// What OpenNI2 says about the call that failed last on this thread, in one line.
[[nodiscard]] std::string openni2_error();

// That the device with this URI (empty: any) could not be opened, OpenNI2's reason, and what to do.
// `there`: OpenNI2 knows the device.
[[nodiscard]] std::string explain_open(const std::string& uri, const std::string& reason,
                                       bool there);

}  // namespace cleave::sensor
