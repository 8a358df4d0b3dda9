// SPDX-License-Identifier: BSD-3-Clause
#include "recording/pcd/stream_cloud.hpp"

#include <algorithm>

#include "recording/cloud/fit_intrinsics.hpp"
#include "recording/cloud/measured.hpp"
#include "recording/pcd/cloud.hpp"
#include "recording/units/suspected_unit.hpp"

namespace cleave::recording {

StreamCloud read_stream_cloud(const std::filesystem::path& file, std::uint64_t most_points,
                              std::optional<Unit> unit) {
  const PcdCloud pcd = PcdCloud::read(file, most_points);
  StreamCloud cloud{.width = pcd.header().width,
                    .height = pcd.header().height,
                    .xyz = {pcd.xyz().begin(), pcd.xyz().end()},
                    .intrinsics = {},
                    .origin = pcd.origin()};
  for (std::size_t i = 0; i < cloud.xyz.size(); i += 3) {
    float* const p = &cloud.xyz[i];
    if (is_measured(p)) continue;
    std::fill_n(p, 3, no_measurement);
  }
  make_metres(cloud.xyz, unit, file.string());
  for (double& coordinate : cloud.origin) {
    coordinate /= units_a_metre(unit.value_or(Unit::metre));
  }
  cloud.intrinsics = fit_intrinsics(cloud.xyz.data(), cloud.width, cloud.height);
  return cloud;
}

}  // namespace cleave::recording
