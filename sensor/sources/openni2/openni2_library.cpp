// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/sources/openni2/openni2_library.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>

namespace cleave::sensor {
namespace {

Failure initialise() {
  std::error_code error;
  const std::filesystem::path here = std::filesystem::current_path(error);
  const openni::Status status = openni::OpenNI::initialize();
  if (!error) std::filesystem::current_path(here, error);
  if (error) spdlog::warn("cannot restore the working directory: {}", error.message());
  if (status == openni::STATUS_OK) return std::nullopt;
  return "cannot initialise OpenNI2: " + openni2_error() +
         "; are its drivers in OpenNI2/Drivers beside libOpenNI2.so.0?";
}

}  // namespace

Failure initialise_openni2() {
  static const Failure failure = initialise();
  return failure;
}

std::string openni2_error() {
  std::string text = openni::OpenNI::getExtendedError();
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
  while (!text.empty() && text.back() == ' ') text.pop_back();
  text.erase(0, text.find_first_not_of(' '));
  return text.empty() ? "OpenNI2 gives no reason" : text;
}

std::string explain_open(const std::string& uri, const std::string& reason, bool there) {
  const std::string what = "cannot open " +
                           (uri.empty() ? std::string("a camera") : "'" + uri + "'") + ": " +
                           reason + ". ";
  if (!there) {
    return what +
           "No such device is there for this user: does `lsusb` list it, are the udev rules of "
           "libopenni2-0 in force (config/README.md)?";
  }
  return what +
         "It is there: does another program use it, may this user open it (the udev rules of "
         "libopenni2-0, config/README.md)?";
}

}  // namespace cleave::sensor
