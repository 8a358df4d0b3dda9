// SPDX-License-Identifier: BSD-3-Clause
// PCL's supervoxels of a cloud. PCL's types stay within this folder's sources.
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/supervoxel_clustering.h>

#include <cstdint>
#include <map>

#include "workbench/peers/peer.hpp"

namespace cleave::peers {

using PclPoint = pcl::PointXYZRGBA;  // for which PCL brings the clustering compiled
using PclCloud = pcl::PointCloud<PclPoint>;

// PCL reports as errors what is part of a day's work (CPC: a plane that no edge supports). Its
// level is one variable for all threads: set it before any runs.
void silence_pcl();

[[nodiscard]] PclCloud::Ptr to_pcl(const segmentation::CloudView& cloud);

struct PclSupervoxels {
  std::map<std::uint32_t, pcl::Supervoxel<PclPoint>::Ptr> clusters;  // by label, from 1
  std::multimap<std::uint32_t, std::uint32_t> adjacency;             // both ways
  pcl::PointCloud<pcl::PointXYZL>::Ptr labelled;                     // 0 = in no supervoxel
};

[[nodiscard]] PclSupervoxels cluster(const PclCloud::Ptr& cloud,
                                     const SupervoxelParameters& parameters);

}  // namespace cleave::peers
