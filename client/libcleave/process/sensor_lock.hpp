// SPDX-License-Identifier: BSD-3-Clause
// One grabber a sensor and domain on a machine.
#pragma once

#include <cstdint>
#include <string>

namespace cleave {

// An abstract Unix socket by the name of the sensor: the kernel releases it when the process ends,
// however it ends. (Containers with a network namespace of their own do not see each other's.)
class SensorLock {
 public:
  // Throws std::runtime_error that names the process which publishes this sensor already.
  SensorLock(std::uint32_t domain, const std::string& sensor);
  ~SensorLock();
  SensorLock(const SensorLock&) = delete;
  SensorLock& operator=(const SensorLock&) = delete;

 private:
  int socket_;
};

}  // namespace cleave
