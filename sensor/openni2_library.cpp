#include "sensor/openni2_library.hpp"

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
  return text.empty() ? "OpenNI2 gives no reason" : text;
}

std::string explain_open(const std::string& uri, openni::Status status) {
  const std::string what = "cannot open " +
                           (uri.empty() ? std::string("a camera") : "'" + uri + "'") + ": " +
                           openni2_error() + ". ";
  if (uri.empty() || status == openni::STATUS_NO_DEVICE) {
    return what +
           "No such device is there for this user: does `lsusb` list it, are the udev rules of "
           "libopenni2-0 in force (config/README.md)?";
  }
  return what + "Is another program using it, and is the URI right (`lsusb` lists bus and device)?";
}

}  // namespace cleave::sensor
