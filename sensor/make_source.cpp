#include "sensor/make_source.hpp"

#include <stdexcept>

#include "sensor/pcd_source.hpp"

namespace cleave::sensor {
namespace {

constexpr char sources[] =
    "Sources are\n"
    "  openni2:          the first camera\n"
    "  openni2:URI       one camera, e.g. openni2:1d27/0609@2/5\n"
    "  synthetic:SCENE   the synthetic camera, e.g. synthetic:medium\n"
    "  pcd:PATH          a point cloud or a folder of them, e.g. pcd:recordings";

}  // namespace

std::unique_ptr<Source> make_source(const std::string& uri, const VideoMode& mode, bool loop) {
  const std::size_t colon = uri.find(':');
  const std::string scheme = uri.substr(0, colon);
  const std::string rest = colon == std::string::npos ? "" : uri.substr(colon + 1);
  if (colon != std::string::npos) {
    if (scheme == "openni2") return std::make_unique<OpenNi2Source>(rest, mode);
    if (scheme == "synthetic" && !rest.empty()) return std::make_unique<OpenNi2Source>(uri, mode);
    if (scheme == "pcd" && !rest.empty()) return std::make_unique<PcdSource>(rest, loop);
    if (scheme == "oni" || scheme == "mcap") {
      throw std::invalid_argument("source '" + uri + "': " + scheme +
                                  ": is not supported in this version. " + sources);
    }
  }
  throw std::invalid_argument("source '" + uri + "' is not known. " + sources);
}

}  // namespace cleave::sensor
