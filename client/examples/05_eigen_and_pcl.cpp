// SPDX-License-Identifier: BSD-3-Clause
// The types that planners have: a cloud as an Eigen::Map, without a copy, and the points of a
// segment as a labelled cloud of PCL.
//
//   build/release/bin/05_eigen_and_pcl [SENSOR]
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>
#include <cstdio>
#include <span>

#include "libcleave/frames/frame_reader.hpp"
#include "libcleave/process/shutdown.hpp"

namespace {

// A column a point, in the memory that the grabber wrote.
using Points = Eigen::Map<const Eigen::Matrix3Xf>;

pcl::PointCloud<pcl::PointXYZL> points_of(const cleave::CompleteFrame& frame, std::uint16_t label) {
  const std::span<const std::uint16_t> labels = frame.labels.labels();
  const Points points(frame.cloud.xyz().data(), 3, static_cast<Eigen::Index>(labels.size()));
  pcl::PointCloud<pcl::PointXYZL> segment;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] != label) continue;
    const auto point = points.col(static_cast<Eigen::Index>(i));
    segment.push_back(pcl::PointXYZL(point.x(), point.y(), point.z(), label));
  }
  return segment;
}

}  // namespace

int main(int argc, char** argv) {
  const char* const sensor = argc > 1 ? argv[1] : "camera";
  cleave::Shutdown shutdown;
  cleave::Stream stream(cleave::with_environment({}));
  cleave::FrameReader frames(stream, sensor);
  shutdown.on_request([&] { frames.wake(); });

  while (!shutdown.requested()) {
    const auto frame = frames.next(std::chrono::seconds(1));
    if (!frame) continue;
    const auto object = points_of(*frame, 2);
    std::printf("frame %llu: segment 2 has %zu points\n",
                static_cast<unsigned long long>(frame->cloud.header().frame_id), object.size());
  }
  return 0;
}
