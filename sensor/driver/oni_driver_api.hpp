// SPDX-License-Identifier: BSD-3-Clause
// OpenNI2's driver interface, without the XnLib that its macros expect.
#pragma once

#define XN_NEW(type, ...) new type(__VA_ARGS__)
#define XN_DELETE(pointer) delete (pointer)
#include <Driver/OniDriverAPI.h>

#include <cstring>
#include <exception>

namespace cleave::driver {

// Copies a property's value out to OpenNI2, if that left room for exactly such a value.
template <class T>
OniStatus answer(const T& value, void* data, int* size) {
  if (*size != static_cast<int>(sizeof(T))) return ONI_STATUS_BAD_PARAMETER;
  std::memcpy(data, &value, sizeof(T));
  return ONI_STATUS_OK;
}

// OpenNI2 is C: an exception becomes a line of its extended error, and `failure` the result.
template <class Result, class Body>
Result guarded(oni::driver::DriverServices& services, Result failure, Body body) {
  try {
    return body();
  } catch (const std::exception& error) {
    services.errorLoggerAppend("%s", error.what());
    return failure;
  }
}

}  // namespace cleave::driver
