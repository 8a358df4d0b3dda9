// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/sources/openni2/openni2_mode.hpp"

#include "sensor/sources/openni2/openni2_library.hpp"

namespace cleave::sensor {

bool is_depth(openni::PixelFormat format) {
  return format == openni::PIXEL_FORMAT_DEPTH_1_MM || format == openni::PIXEL_FORMAT_DEPTH_100_UM;
}

std::string describe(const openni::VideoMode& mode) {
  return std::to_string(mode.getResolutionX()) + "x" + std::to_string(mode.getResolutionY()) + "@" +
         std::to_string(mode.getFps());
}

Failure set_mode(openni::VideoStream& stream, const VideoMode& wanted) {
  openni::VideoMode mode;
  mode.setResolution(static_cast<int>(wanted.width), static_cast<int>(wanted.height));
  mode.setFps(static_cast<int>(wanted.fps));
  mode.setPixelFormat(openni::PIXEL_FORMAT_DEPTH_100_UM);
  const auto& modes = stream.getSensorInfo().getSupportedVideoModes();
  bool found = false;
  std::string known;
  for (int i = 0; i < modes.getSize(); ++i) {
    if (!is_depth(modes[i].getPixelFormat())) continue;
    if (known.find(describe(modes[i])) == std::string::npos) known += " " + describe(modes[i]);
    if (describe(modes[i]) != describe(mode)) continue;
    found = true;
    if (modes[i].getPixelFormat() == openni::PIXEL_FORMAT_DEPTH_1_MM) mode = modes[i];
  }
  if (!found) return "the camera has no depth mode " + describe(mode) + ", only" + known;
  if (stream.setVideoMode(mode) == openni::STATUS_OK) return std::nullopt;
  return "the camera refuses depth mode " + describe(mode) + ": " + openni2_error();
}

Failure set_mirroring(openni::VideoStream& stream, bool wanted) {
  if (stream.getMirroringEnabled() == wanted) return std::nullopt;
  if (stream.setMirroringEnabled(wanted) == openni::STATUS_OK) return std::nullopt;
  return std::string(wanted ? "the camera cannot mirror its image (video.mirror)"
                            : "the camera mirrors its image and cannot be told not to") +
         ": " + openni2_error();
}

Failure set_registration(openni::Device& device, bool wanted) {
  const auto mode =
      wanted ? openni::IMAGE_REGISTRATION_DEPTH_TO_COLOR : openni::IMAGE_REGISTRATION_OFF;
  if (wanted && !device.isImageRegistrationModeSupported(mode)) {
    return "the camera cannot register its depth to a colour image: switch video.registration off";
  }
  if (device.getImageRegistrationMode() == mode) return std::nullopt;
  if (device.setImageRegistrationMode(mode) == openni::STATUS_OK) return std::nullopt;
  return std::string("the camera does not switch registration ") + (wanted ? "on" : "off") + ": " +
         openni2_error();
}

}  // namespace cleave::sensor
