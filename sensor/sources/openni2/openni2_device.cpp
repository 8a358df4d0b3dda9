// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/sources/openni2/openni2_device.hpp"

#include <array>
#include <string_view>
#include <vector>

#include "libcleave/process/companion.hpp"
#include "sensor/sources/openni2/openni2_library.hpp"

namespace cleave::sensor {
namespace {

constexpr std::string_view serial_prefix = "serial=";
constexpr std::string_view synthetic_prefix = "synthetic:";
constexpr char synthetic_driver[] = "openni2/OpenNI2/Drivers/libCleaveSynthetic.so.0";

std::vector<std::string> listed_uris() {
  openni::Array<openni::DeviceInfo> devices;
  openni::OpenNI::enumerateDevices(&devices);
  std::vector<std::string> uris;
  uris.reserve(static_cast<std::size_t>(devices.getSize()));
  for (int i = 0; i < devices.getSize(); ++i) uris.emplace_back(devices[i].getUri());
  return uris;
}

std::string serial_of(openni::Device& device) {
  std::array<char, 512> text{};
  int size = static_cast<int>(text.size()) - 1;
  const auto status = device.getProperty(openni::DEVICE_PROPERTY_SERIAL_NUMBER, text.data(), &size);
  return status == openni::STATUS_OK ? text.data() : "";
}

OpenResult open_by_serial(openni::Device& device, const std::string& serial) {
  std::string seen;
  std::string closed;
  for (const std::string& uri : listed_uris()) {
    if (device.open(uri.c_str()) != openni::STATUS_OK) {
      closed.append("; '").append(uri).append("' cannot be opened: ").append(openni2_error());
      continue;
    }
    const std::string found = serial_of(device);
    if (found == serial) return {};
    device.close();
    seen.append(" '").append(found).append("' (").append(uri).append(")");
  }
  return {"cannot open a camera: none has the serial number '" + serial + "'; there " +
              (seen.empty() ? "is no other" : "are" + seen) + closed,
          !closed.empty()};
}

}  // namespace

OpenResult open_device(openni::Device& device, const std::string& uri) {
  if (uri.starts_with(serial_prefix)) {
    return open_by_serial(device, uri.substr(serial_prefix.size()));
  }
  const openni::Status status = device.open(uri.empty() ? openni::ANY_DEVICE : uri.c_str());
  if (status == openni::STATUS_OK) return {};
  const std::string reason = openni2_error();  // before another call makes OpenNI2 forget it
  // Without a URI, the status is the same where no camera is and where it cannot be had.
  const bool there = status != openni::STATUS_NO_DEVICE && !listed_uris().empty();
  if (!there && uri.starts_with(synthetic_prefix) && !find_companion(synthetic_driver)) {
    return {missing_companion(synthetic_driver,
                              "it is the synthetic camera: build the target "
                              "cleave_synthetic_driver, or install cleave-grabber anew"),
            false};
  }
  return {explain_open(uri, reason, there), there};
}

}  // namespace cleave::sensor
