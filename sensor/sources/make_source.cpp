// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/sources/make_source.hpp"

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "recording/ros/file_topic.hpp"
#include "sensor/sources/decimating_source.hpp"
#include "sensor/sources/mcap_source.hpp"
#include "sensor/sources/oni_source.hpp"
#include "sensor/sources/pcd_source.hpp"

namespace cleave::sensor {
namespace {

constexpr char sources[] =
    "Sources are\n"
    "  openni2:          the first camera\n"
    "  openni2:URI       one camera, e.g. openni2:1d27/0609@2/5\n"
    "  openni2:serial=N  the camera with this serial number\n"
    "  synthetic:SCENE   the synthetic camera, e.g. synthetic:medium\n"
    "  pcd:PATH          a point cloud or a folder of them, e.g. pcd:recordings\n"
    "  oni:FILE          a recording by OpenNI, e.g. oni:table.oni\n"
    "  mcap:FILE         a recording by `cleave record`, or a bag of ROS 2 in MCAP, e.g.\n"
    "                    mcap:run.mcap or mcap:bag.mcap?topic=/camera/depth/points";

// Reads the number that the URI names for a key, or adds the key with the number.
void read_or_add(std::string& uri, std::string_view key, std::uint32_t& number) {
  const std::size_t options = std::min(uri.find('?'), uri.size());
  const std::string option = std::string(key) + "=";
  const std::size_t named =
      std::min(uri.find("?" + option, options), uri.find("&" + option, options));
  if (named == std::string::npos) {
    uri += (options == uri.size() ? "?" : "&") + option + std::to_string(number);
  } else {
    // What is no number here the driver refuses, with a better message.
    std::from_chars(uri.data() + named + 1 + option.size(), uri.data() + uri.size(), number);
  }
}

// The synthetic camera has the one mode that its URI names; `mode` fills in what it does not name.
std::unique_ptr<Source> make_synthetic(std::string uri, VideoMode mode) {
  read_or_add(uri, "fps", mode.fps);
  read_or_add(uri, "width", mode.width);
  read_or_add(uri, "height", mode.height);
  return std::make_unique<OpenNi2Source>(std::move(uri), mode);
}

std::unique_ptr<Source> make_mcap(const std::string& text, const Playback& playback,
                                  std::uint64_t max_points) {
  const recording::FileTopic from = recording::split_topic(text);
  return std::make_unique<McapSource>(from.file, playback.loop, from.topic, playback.gaps,
                                      playback.unit, max_points);
}

// With images of so many points as the source has; `max_points` of files.
std::unique_ptr<Source> make_whole(const std::string& uri, const VideoMode& mode,
                                   const Playback& playback, std::uint64_t max_points) {
  const std::size_t colon = uri.find(':');
  const std::string scheme = uri.substr(0, colon);
  const std::string rest = colon == std::string::npos ? "" : uri.substr(colon + 1);
  if (colon != std::string::npos) {
    if (scheme == "openni2") return std::make_unique<OpenNi2Source>(rest, mode);
    if (scheme == "synthetic" && !rest.empty()) return make_synthetic(uri, mode);
    if (scheme == "pcd" && !rest.empty()) {
      return std::make_unique<PcdSource>(rest, playback.loop, playback.unit, max_points);
    }
    if (scheme == "oni" && !rest.empty()) {
      return std::make_unique<OniSource>(rest, playback.loop, max_points);
    }
    if (scheme == "mcap" && !rest.empty()) return make_mcap(rest, playback, max_points);
  }
  throw std::invalid_argument("source '" + uri + "' is not known. " + sources);
}

}  // namespace

std::unique_ptr<Source> make_source(const std::string& uri, const VideoMode& mode,
                                    const Playback& playback, const Treatment& treatment) {
  const std::uint32_t decimate = treatment.decimate;
  const std::uint64_t max_points = std::uint64_t{decimate} * decimate * capacity_points;
  std::unique_ptr<Source> source = make_whole(uri, mode, playback, max_points);
  if (!treatment.calibration.changes_nothing()) {
    source = std::make_unique<CalibratedSource>(std::move(source), treatment.calibration);
  }
  if (decimate == 1) return source;
  return std::make_unique<DecimatingSource>(std::move(source), decimate);
}

}  // namespace cleave::sensor
